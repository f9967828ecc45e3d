# SPDX-License-Identifier: MIT
"""ocellus-sim run --record: files that fit each other, and the same again."""

import csv
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "sim"))
from sim_program import SimTest  # pylint: disable=wrong-import-position

SCENARIO = pathlib.Path(__file__).with_name("replay.toml")
FILES = ("manifest.txt", "frames.rgb565", "pairs.csv", "answers.csv")


class RecordTest(SimTest):
    def record(self, out, *options):
        return self.run_program("run", self.small, "--out", "out", "--record", out, *options)

    def setUp(self):
        super().setUp()
        text = SCENARIO.read_text()
        for old, new in (("320x240", "160x120"), ("[0.0, 0.25, 0.5, 0.75]", "[0.0, 0.5]")):
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.small = self.folder / "small.toml"
        self.small.write_text(text)

    def test_files_fit_each_other_and_come_out_the_same_again(self):
        for out in ("one", "two"):
            finished = self.record(out)
            self.assertEqual(finished.returncode, 0, finished.stderr)
        for name in FILES:
            self.assertEqual((self.folder / "one" / name).read_bytes(),
                             (self.folder / "two" / name).read_bytes(), name)
        tables = {}
        for name in ("pairs", "answers"):
            with open(self.folder / "one" / f"{name}.csv", newline="") as file:
                tables[name] = list(csv.DictReader(file))
        pairs, answers = tables["pairs"], tables["answers"]
        self.assertEqual(pairs[0]["frame"], "0")
        self.assertEqual([(row["point"], row["trial"], row["frame"]) for row in pairs],
                         [(row["point"], row["trial"], row["frame"]) for row in answers])
        self.assertEqual((self.folder / "one" / "frames.rgb565").stat().st_size,
                         len(pairs) * 2 * 160 * 120 * 2)
        self.assertIn("width 160\n", (self.folder / "one" / "manifest.txt").read_text())
        self.assertEqual(answers[0]["ball.has_stereo"], "1")

    def test_a_recording_is_not_shared_by_processes(self):
        finished = self.record("rec", "--jobs", 2)
        self.assertEqual(finished.returncode, 2)
        self.assertIn("expected --jobs 1", finished.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_a_folder_that_cannot_be_made_is_named(self):
        (self.folder / "rec").write_text("a file")
        finished = self.record("rec")
        self.assertEqual(finished.returncode, 2)
        self.assertIn("--record rec: cannot be made", finished.stderr)


if __name__ == "__main__":
    unittest.main()
