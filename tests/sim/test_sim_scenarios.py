# SPDX-License-Identifier: MIT
"""Each scenario at a small size: what is written, and what it shows."""

import math

from sim_program import SCENARIOS, SimTest

COLUMNS = ("scenario,point,trial,seed,method,distance,occlusion,status,true_x,true_y,true_z,"
           "est_x,est_y,est_z,err,true_radius,est_radius,radius_err_pct").split(",")
METHODS = {"hough_gradient", "hough_alt", "b2ac_strict", "b2ac", "lcse", "edfe", "edfe_200",
           "hyper", "sphere"}
EYES_MIDDLE_X = 0.36


def mean(rows, column):
    values = [float(row[column]) for row in rows]
    return sum(values) / len(values)


class Scenarios(SimTest):
    def run_small(self, name, trials):
        rows, summary = self.run_scenario(SCENARIOS / f"{name}.toml", name, "--trials", trials,
                                          "--jobs", 2)
        self.assertEqual(list(rows[0])[:len(COLUMNS)], COLUMNS)
        self.assertEqual({row["method"] for row in rows}, METHODS)
        self.assertGreaterEqual(len(summary["points"]), 12)
        self.assertEqual(len(rows), len(summary["points"]) * trials * len(METHODS))
        self.assertEqual(len(list((self.folder / name / "pictures").iterdir())),
                         len(summary["points"]))
        self.check_rows(rows)
        by_method = {method: [row for row in rows if row["method"] == method]
                     for method in METHODS}
        return by_method, summary

    def check_rows(self, rows):
        for row in rows:
            self.assertNotIn("nan", ",".join(row.values()))
            distance = float(row["true_x"]) - EYES_MIDDLE_X
            self.assertAlmostEqual(float(row["distance"]), distance, places=9)
            if row["est_x"]:
                off = [float(row["est_" + axis]) - float(row["true_" + axis]) for axis in "xyz"]
                self.assertAlmostEqual(float(row["err"]), math.hypot(*off), places=8)
            else:
                self.assertEqual(row["err"], "")
                self.assertNotEqual(row["status"], "ok")

    def test_a_cylinder(self):
        rows, summary = self.run_small("a_cylinder", 2)
        # Raw, the bias r^2/d is most of the error; without it little is left.
        near = [row for row in rows["b2ac"] if float(row["distance"]) < 1.3]
        bias = mean(near, "est_x") - mean(near, "true_x")
        self.assertAlmostEqual(bias, 0.17 ** 2 / 1.2, delta=0.006)
        for method in ("b2ac", "lcse"):
            self.assertLess(mean(rows[method], "err_debiased"), 0.007)
        for row in rows["b2ac"]:
            self.assertLess(int(row["frames"]), 25)
            self.assertTrue(row["err_encoder"])
        self.assertEqual(summary["varied"], "distance")

    def test_b_occlusion(self):
        rows, summary = self.run_small("b_occlusion", 2)
        for row in rows["sphere"]:
            wanted = summary["points"][int(row["point"])]
            self.assertAlmostEqual(float(row["occlusion"]), wanted, delta=0.005)
            self.assertLess(abs(float(row["radius_true_depth_err_pct"])), 1.0)
        half = [row for row in rows["b2ac"] if float(row["occlusion"]) > 0.49]
        self.assertAlmostEqual(mean(half, "radius_true_depth_err_pct"), -28, delta=6)
        clear = [row for row in rows["b2ac"] if float(row["occlusion"]) == 0]
        self.assertAlmostEqual(mean(clear, "radius_err_pct"), 0.4, delta=0.8)

    def test_c_distance(self):
        rows, summary = self.run_small("c_distance", 2)
        error = {method: mean(rows[method], "err") for method in METHODS}
        self.assertLess(error["sphere"], 0.0035)
        self.assertLess(error["b2ac"], 0.008)
        self.assertGreater(error["hough_gradient"], error["b2ac"])
        self.assertAlmostEqual(summary["methods"]["sphere"]["all"]["err"]["mean"],
                               error["sphere"], delta=1e-6)


if __name__ == "__main__":
    import unittest
    unittest.main()
