# SPDX-License-Identifier: MIT
"""ocellus-sim as a program: help, mistakes, and that a run repeats itself."""

import json

from sim_program import SCENARIOS, SimTest

# Where each wrong text stands is found by looking for it in the file.
WRONG = (
    ('radius = 0.17 ', 'radius = "big" ', '"big"', "[target] radius", "0.01 .. 2 SMU"),
    ('radius = 0.17 ', 'radius = -1.0 ', "-1.0", "[target] radius", "0.01 .. 2 SMU"),
    ('noise = 0.0 ', 'noize = 0.0 ', "noize", "[camera] noize: is no key here", "noise"),
    ('"icub-2010" ', '"icub-2011" ', '"icub-2011"', "[camera] preset", "icub-2010-06 or icub-2009"),
    ('min_area = 16', 'min_area = 16.5', "16.5", "[detector] min_area", "a whole number"),
    ('"hyper", ', '"best", ', '"best"', "[detector] methods", "hyper or sphere"),
    ('points = [1.2,', 'points = [0.0,', "0.0,", "[sweep] points", "0.3 .. 20 SMU"),
    ('"yuv:0-255,174-255,0-255"', '"yuv:9-1"', '"yuv:9-1"', "[detector] colour", "yuv:y0-y1"),
    ('colour = [20, 60, 230]', 'colour = [20, 60]', "[20, 60]", "[target] colour", "red, green"),
    ('focus = 2.3 ', 'focus = 2.3\nframes = 25 ', "frames", "[gaze] frames", "no meaning"),
    ('noise = 0.0 ', 'noise = 0.0\ndistortion = [0.1, 0.2] ', "[0.1, 0.2]", "[camera] distortion",
     "k1, k2, p1, p2 and k3"),
    ('noise = 0.0 ', 'noise = 0.0\ndistortion = [-0.9, 0, 0, 0, 0] ', "[-0.9", "[camera] distortion",
     "leaves pixel (0, 0) without a ray"),
    ('noise = 0.0 ', 'noise = 0.0\nexposure = 0.01\nsubframes = 8 ', "0.01", "[camera] exposure",
     "nothing moves"),
    ('noise = 0.0 ', 'noise = 0.0\nreadout = 0.01 ', "0.01", "[camera] readout", "nothing moves"),
    ('noise = 0.0 ', 'noise = 0.0\nreadout = 0.25 ', "0.25", "[camera] readout", "0 .. 0.033 s"),
    ('noise = 0.0 ', 'noise = 0.0\nsubframes = 8 ', "subframes", "[camera] subframes", "no meaning"),
    ('mode = "still" ', 'mode = still ', "still  #", "is no TOML", ""),
)


class Program(SimTest):
    def test_help_names_what_there_is(self):
        text = self.run_program("--help").stdout
        for command in ("merge", "paper", "report", "run", "track"):
            self.assertIn(command, text)
        self.assertIn("trials.csv", self.run_program("run", "--help").stdout)
        self.assertIn("ocellus-sim", self.run_program("--version").stdout)

    def test_usage(self):
        for arguments in ((), ("fly",), ("run",), ("run", "x.toml"),
                          ("run", "x.toml", "--out", "o", "--trials", "0")):
            finished = self.run_program(*arguments)
            self.assertEqual(finished.returncode, 2, arguments)
            self.assertIn("error: ", finished.stderr)

    def test_a_wrong_scenario_is_told_its_place(self):
        for old, new, found, *parts in WRONG:
            path = self.variant("c_distance.toml", (old, new))
            finished = self.run_program("run", path, "--out", "out")
            self.assertEqual(finished.returncode, 2, new)
            lines = path.read_text().splitlines()
            line = next(n for n, text in enumerate(lines, 1)
                        if found in text and not text.startswith("#"))
            column = lines[line - 1].index(found) + 1
            self.assertIn(f"{path}:{line}:", finished.stderr)
            if parts[0] != "is no TOML":
                self.assertIn(f"{path}:{line}:{column}:", finished.stderr)
            for part in parts:
                self.assertIn(part, finished.stderr)
            self.assertFalse((self.folder / "out").exists())

    def test_a_missing_key_or_file_is_named(self):
        path = self.variant("c_distance.toml", ("jitter = 0.1 ", "# "))
        finished = self.run_program("run", path, "--out", "out")
        self.assertIn("[sweep] jitter: is missing", finished.stderr)
        finished = self.run_program("run", "none.toml", "--out", "out")
        self.assertEqual(finished.returncode, 2)
        self.assertIn("none.toml: cannot be read", finished.stderr)

    def test_a_folder_that_cannot_be_made(self):
        finished = self.run_program("run", SCENARIOS / "c_distance.toml", "--out", "/dev/null/x")
        self.assertEqual(finished.returncode, 2)
        self.assertIn("--out /dev/null/x", finished.stderr)

    def test_same_seed_same_bytes_whatever_the_jobs(self):
        path = self.variant("b_occlusion.toml", ('size = "320x240"', 'size = "160x120"'),
                            ("noise = 0.0", "noise = 2.0"), ('"plain"', '"cluttered"'),
                            ("points = [0.0, 0.025, 0.05, 0.075, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, "
                             "0.4, 0.45, 0.5]", "points = [0.0, 0.1, 0.3]"))
        outs = {"one": ("--jobs", 1), "again": ("--jobs", 1), "two": ("--jobs", 2),
                "other": ("--seed", 2)}
        for out, options in outs.items():
            self.run_scenario(path, out, "--trials", 2, *options)
        for name in ("trials.csv", "summary.json", "pictures/b_occlusion_p02.png"):
            content = {out: (self.folder / out / name).read_bytes() for out in outs}
            self.assertEqual(content["one"], content["again"], name)
            self.assertEqual(content["one"], content["two"], name)
            self.assertNotEqual(content["one"], content["other"], name)

    def test_a_status_against_the_truth_is_told_and_fails_the_run(self):
        # Eyes that take a distractor for the target, which is far to the side.
        path = self.variant("c_distance.toml", ('size = "320x240"', 'size = "160x120"'),
                            ("jitter = 0.1 ", "jitter = 1.0 "), ('"plain"', '"cluttered"'),
                            ('"yuv:0-255,174-255,0-255"', '"hsv:345-15,100-255,50-255"'))
        finished = self.run_program("run", path, "--out", "out", "--trials", 4)
        self.assertEqual(finished.returncode, 2)
        told = [line for line in finished.stderr.splitlines() if "not in view" in line]
        self.assertRegex(told[0], "ocellus-sim: error: c_distance, point [0-9]+, trial [0-9], "
                                  "frame 0, (left|right) eye: status ok, but the target")
        checks = json.loads((self.folder / "out/summary.json").read_text())["checks"]
        self.assertEqual(checks["violations"], len(told))
        self.assertIn(f"{len(told)} of the library's bounds or statuses", finished.stderr)

    def test_a_trial_does_not_depend_on_those_before_it(self):
        path = SCENARIOS / "c_distance.toml"
        few, _ = self.run_scenario(path, "few", "--trials", 1)
        many, _ = self.run_scenario(path, "many", "--trials", 2)
        self.assertEqual(few, [row for row in many if row["trial"] == "0"])


if __name__ == "__main__":
    import unittest
    unittest.main()
