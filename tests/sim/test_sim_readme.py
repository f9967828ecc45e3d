# SPDX-License-Identifier: MIT
"""The table of scenario keys in hostsim/README.md is what the parser takes."""

import re

from sim_program import SCENARIOS, SimTest

TABLES = {
    "c_distance.toml": ("run", ("top", "sweep", "camera", "target", "scene", "gaze", "detector")),
    "track_occluded.toml": ("track", ("run", "ball", "screen", "tracker", "gaze", "detector")),
}


class Readme(SimTest):
    def keys_of_parser(self, command, name, table):
        """What the parser expects, as it says when it meets a key that is none."""
        text = "zzz = 1\n" + (SCENARIOS / name).read_text()
        if table != "top":
            text = re.sub(rf"(?m)^(\[+{table}\]+.*)$", r"\1\nzzz = 1", text[8:], count=1)
        path = self.folder / "with_zzz.toml"
        path.write_text(text)
        error = self.run_program(command, path, "--out", "out").stderr
        found = re.search(r"zzz: is no key here; expected (.*)", error)
        self.assertIsNotNone(found, error)
        return set(re.split(", | or ", found[1]))

    def test_keys(self):
        readme = (SCENARIOS.parent / "README.md").read_text().split("\n## Tracking\n")[0]
        rows = re.findall(r"(?m)^\| ([a-z, ]+) \| (\w+) \|", readme)
        documented, tables = {}, set()
        for table, key in rows:
            if (table, key) not in (("table", "key"), ("what", "where")):
                documented.setdefault(table, set()).add(key)
        for name, (command, names) in TABLES.items():
            for table in names:
                row = f"{table}, {command}" if table in ("gaze", "detector") else table
                keys = self.keys_of_parser(command, name, table)
                tables |= {row}
                if table == "top":
                    keys = {"name"}
                self.assertEqual(documented.get(row), keys, row)
        self.assertEqual(set(documented), tables)


if __name__ == "__main__":
    import unittest
    unittest.main()
