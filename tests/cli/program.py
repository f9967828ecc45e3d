# SPDX-License-Identifier: MIT
"""Runs the program under test; its path is in the environment as OCELLUS."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest


class Answer:
    """What one run printed, and its exit code."""

    def __init__(self, finished):
        self.code = finished.returncode
        self.out = finished.stdout.decode()
        self.err = finished.stderr.decode(errors="replace")
        self.lines = [json.loads(line) for line in self.out.splitlines()] if self.code != 2 else []

    @property
    def json(self):
        assert len(self.lines) == 1, self.out + self.err
        return self.lines[0]


class ProgramTest(unittest.TestCase):
    """A folder for files, and runs of the program in it."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def run_program(self, *arguments, stdin=b""):
        finished = subprocess.run([os.environ["OCELLUS"], *map(str, arguments)], input=stdin,
                                  cwd=self.folder, capture_output=True, timeout=120, check=False)
        self.assertIn(finished.returncode, (0, 1, 2), finished.stderr)
        return Answer(finished)

    def assert_refused(self, answer, *parts):
        """Exit 2, nothing on stdout, and a message with all these parts."""
        self.assertEqual(answer.code, 2, answer.out + answer.err)
        self.assertEqual(answer.out, "")
        self.assertIn("error: ", answer.err)
        for part in parts:
            self.assertIn(part, answer.err)
