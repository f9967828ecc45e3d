# SPDX-License-Identifier: MIT
"""The demo's two photographs.  The expected ellipses are OpenCV's (findContours
of the same mask, fitEllipseDirect), whose outline runs half a pixel further in."""

import os
import pathlib
import unittest

from pictures import read_png
from program import ProgramTest

PHOTOS = pathlib.Path(os.environ.get("OCEL_PHOTOS", ""))


@unittest.skipUnless((PHOTOS / "coffee.png").is_file(), "no photographs: run tools/setup.sh")
class Photographs(ProgramTest):
    def assert_ellipse(self, arguments, name, expected):
        answer = self.run_program("detect", *arguments, "--annotate", "out.png", PHOTOS / name)
        got = answer.json
        self.assertEqual((answer.code, got["status"]), (0, "ok"))
        cx, cy, width, height, angle = expected
        self.assertAlmostEqual(got["ellipse"]["cx"], cx, delta=1)
        self.assertAlmostEqual(got["ellipse"]["cy"], cy, delta=1)
        self.assertAlmostEqual(got["ellipse"]["a"], width / 2 + 0.45, delta=1)
        self.assertAlmostEqual(got["ellipse"]["b"], height / 2 + 0.45, delta=1)
        self.assertAlmostEqual(got["ellipse"]["angle_deg"], angle, delta=3)
        return read_png((self.folder / "out.png").read_bytes())[:2]

    def test_rim_of_the_cup(self):
        size = self.assert_ellipse(["--teach", "178,80,8,48"], "coffee.png",
                                   (290.30, 111.62, 232.79, 186.36, 6.22))
        self.assertEqual(size, (600, 400))

    def test_largest_coin(self):
        size = self.assert_ellipse(["--colour", "gray:122-255"], "coins.png",
                                   (347.40, 185.95, 63.10, 59.25, 12.46))
        self.assertEqual(size, (384, 303))
