# SPDX-License-Identifier: MIT
"""The program around its commands: help, version, usage, bench."""

import os
import pathlib
import re
import subprocess

from program import ProgramTest

VERSION_HEADER = pathlib.Path(__file__).parents[2] / "lib/include/ocellus/version.h"


class Program(ProgramTest):
    def test_version_is_the_headers(self):
        version = re.search(r'VERSION_STRING "(.*)"', VERSION_HEADER.read_text()).group(1)
        finished = subprocess.run([os.environ["OCELLUS"], "--version"], capture_output=True,
                                  text=True, check=True)
        self.assertEqual(finished.stdout, f"ocellus {version}\n")

    def test_help_teaches(self):
        for command, parts in (([], ["Exit code", "Examples"]), (["fit"], ["POINTS.csv", "px"]),
                               (["label"], ["MASK"]),
                               (["sphere"], ["POINTS.csv", "z forward", "Examples"]), (["detect"], ["SPEC", "hsv:", "Examples"]),
                               (["bench"], ["this machine"])):
            finished = subprocess.run([os.environ["OCELLUS"], *command, "--help"],
                                      capture_output=True, text=True, check=True)
            for part in parts:
                self.assertIn(part, finished.stdout)

    def test_usage(self):
        self.assert_refused(self.run_program(), "subcommand")
        self.assert_refused(self.run_program("find"), "found 'find'",
                            "fit, label, detect, sphere or bench")
        self.assert_refused(self.run_program("fit"), "POINTS.csv", "--help")
        self.assert_refused(self.run_program("fit", "--speed", "9", "-"), "found '--speed'")
        self.assert_refused(self.run_program("fit", "--method", "best", "-"), "--method 'best'",
                            "b2ac, lcse or hyper")
        self.assert_refused(self.run_program("fit", "--perturb", "maybe", "-"),
                            "auto, always or never")
        self.assert_refused(self.run_program("fit", "--method", "sphere", "-"),
                            "b2ac, lcse or hyper", "ocellus sphere")
        self.assert_refused(self.run_program("sphere"), "POINTS.csv", "--help")

    def test_output_that_cannot_be_written_is_said(self):
        with open("/dev/full", "wb") as full:
            finished = subprocess.run([os.environ["OCELLUS"], "fit", "-"], input=b"1,1\n",
                                      stdout=full, stderr=subprocess.PIPE, check=False)
        self.assertEqual(finished.returncode, 2)
        self.assertIn(b"standard output cannot be written", finished.stderr)

    def test_bench_counts_within_bounds(self):
        stages = self.run_program("bench", "--json").lines
        names = [stage["stage"] for stage in stages]
        for name in ("colour BGR888", "colour RGB565", "colour GRAY8", "label", "boundary",
                     "fit b2ac", "fit lcse", "fit hyper", "camera rays", "lens rays", "cone fit",
                     "sphere", "frame BGR888", "frame RGB565"):
            self.assertIn(name, names)
        for stage in stages:
            self.assertGreater(stage["operations"], 0, stage)
            self.assertLessEqual(stage["operations"], stage["bound"], stage)
            self.assertIn("this machine", stage["figure"])

    def test_bench_table(self):
        finished = subprocess.run([os.environ["OCELLUS"], "bench"], capture_output=True, text=True,
                                  check=True)
        self.assertIn("frame BGR888", finished.stdout)
        self.assertIn("wall time on this machine", finished.stdout)
