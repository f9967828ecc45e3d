# SPDX-License-Identifier: MIT
"""Shards put together are the run in one piece; what is no whole run is refused."""

import re
import subprocess

import yaml

from sim_program import SCENARIOS, SimTest

EXAMPLES = SCENARIOS.parent / "examples"


class Shards(SimTest):
    def setUp(self):
        super().setUp()
        self.path = self.variant("c_distance.toml", ('size = "320x240"', 'size = "160x120"'),
                                 ("noise = 0.0", "noise = 2.0"),
                                 ('"hough_gradient", "hough_alt", ', ""), ('"edfe_200",', ""))

    def run_shard(self, out, *options, path=None):
        self.run_scenario(path or self.path, out, "--trials", 2, *options)

    def merge(self, *folders):
        return self.run_program("merge", "--out", "merged", *folders)

    def assert_refused(self, message, *folders):
        finished = self.merge(*folders)
        self.assertEqual(finished.returncode, 2)
        self.assertRegex(finished.stderr, message)
        self.assertFalse((self.folder / "merged").exists())

    def test_merged_is_the_whole_byte_for_byte(self):
        self.run_shard("whole")
        for shard in (1, 2, 3):
            self.run_shard(f"s{shard}", "--shard", f"{shard}/3", "--jobs", 2)
        finished = self.merge("s2", "s3", "s1")
        self.assertEqual(finished.returncode, 0, finished.stderr)
        names = {str(p.relative_to(self.folder / "whole"))
                 for p in (self.folder / "whole").rglob("*") if p.is_file()}
        self.assertIn("trials.csv", names)
        for name in sorted(names):
            self.assertEqual((self.folder / "whole" / name).read_bytes(),
                             (self.folder / "merged" / name).read_bytes(), name)

    def test_what_is_no_whole_run_is_refused(self):
        self.run_shard("s1", "--shard", "1/2")
        self.run_shard("s2", "--shard", "2/2")
        self.run_shard("seed", "--shard", "2/2", "--seed", 7)
        self.assert_refused("point 0, trial 1 is missing.* of 2/2", "s1")
        self.assert_refused("s1: point 0, trial 0 is in s1 too", "s1", "s2", "s1")
        self.assert_refused("seed: its seed is 7, but that of s1 is 1", "s1", "seed")
        self.assert_refused("none: is no folder", "none")
        scenario = self.folder / "s2" / "scenario.toml"
        scenario.write_text(scenario.read_text() + "# changed\n")
        self.assert_refused("s2/scenario.toml is not that of s1", "s1", "s2")
        rows = self.folder / "s1" / "trials.csv"
        rows.write_text("\n".join(rows.read_text().splitlines()[:-1]) + "\n")
        self.assert_refused("s1/trials.csv: point 11, trial 0 is not whole", "s1")
        rows.write_text(rows.read_text().replace(",ok,", ",fine,", 1))
        self.assert_refused(r"s1/trials.csv:\d+: column status: found 'fine'", "s1")

    def test_a_shard_that_is_none(self):
        for text in ("0/2", "3/2", "1", "1/2x", "a/b"):
            finished = self.run_program("run", self.path, "--out", "o", "--shard", text)
            self.assertEqual(finished.returncode, 2, text)
            self.assertIn("expected k/n", finished.stderr)

    def test_the_examples_are_what_their_readers_take(self):
        subprocess.run(["bash", "-n", EXAMPLES / "slurm_array.sh"], check=True)
        job = (EXAMPLES / "kubernetes_job.yaml").read_text()
        spec = yaml.safe_load(job)["spec"]
        self.assertEqual(spec["completionMode"], "Indexed")
        command = spec["template"]["spec"]["containers"][0]["command"]
        subprocess.run(["sh", "-n", "-c", command[2]], check=True)
        self.assertIn(f'/{spec["completions"]}"', command[2])
        options = set(re.findall(r"--(?:shard|trials|seed|jobs|out)\b", job))
        self.assertEqual(options, {"--shard", "--trials", "--seed", "--jobs", "--out"})


if __name__ == "__main__":
    import unittest
    unittest.main()
