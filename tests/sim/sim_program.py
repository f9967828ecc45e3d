# SPDX-License-Identifier: MIT
"""Runs ocellus-sim; its path is in the environment as OCELLUS_SIM."""

import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

SCENARIOS = pathlib.Path(os.environ["OCEL_SCENARIOS"])


class SimTest(unittest.TestCase):
    """A folder for files, and runs of the program in it."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def run_program(self, *arguments):
        return subprocess.run([os.environ["OCELLUS_SIM"], *map(str, arguments)], cwd=self.folder,
                              capture_output=True, text=True, timeout=300, check=False)

    def run_scenario(self, path, out, *options):
        """The rows of trials.csv and the summary."""
        finished = self.run_program("run", path, "--out", out, *options)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        with open(self.folder / out / "trials.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        return rows, json.loads((self.folder / out / "summary.json").read_text())

    def variant(self, name, *replacements):
        """A copy of a scenario with texts replaced, each of which must stand there."""
        text = (SCENARIOS / name).read_text()
        for old, new in replacements:
            self.assertIn(old, text)
            text = text.replace(old, new)
        path = self.folder / "variant.toml"
        path.write_text(text)
        return path
