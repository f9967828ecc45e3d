# SPDX-License-Identifier: MIT
"""ocellus fit: fields, statuses, published cases, and what it says of bad files."""

import json
import math
import os
import pathlib

from program import ProgramTest

FIELDS = ["status", "method", "cx", "cy", "a", "b", "angle_deg", "rms_px", "n", "perturbed"]


def ellipse_points(cx, cy, a, b, angle_deg, count, arc_deg=360.0):
    turn = math.radians(angle_deg)
    for i in range(count):
        t = math.radians(arc_deg) * i / count
        u, v = a * math.cos(t), b * math.sin(t)
        yield (cx + u * math.cos(turn) - v * math.sin(turn),
               cy + u * math.sin(turn) + v * math.cos(turn))


def csv(points):
    return "".join(f"{x:.12f},{y:.12f}\n" for x, y in points)


def corners(cx, cy, width, height, angle_deg):
    """Of the rectangle around an ellipse; `angle_deg` is that of the width."""
    c, s = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
    for sx, sy in ((-1, -1), (-1, 1), (1, -1), (1, 1)):
        u, v = sx * width / 2, sy * height / 2
        yield cx + u * c - v * s, cy + u * s + v * c


class Published(ProgramTest):
    def test_opencv_direct_cases(self):
        folder = pathlib.Path(os.environ["OCEL_GOLDEN_DIR"])
        expected = json.loads((folder / "opencv_direct_expected.json").read_text())
        for case in ("opencv_direct_1", "opencv_direct_2", "opencv_direct_3"):
            got = self.run_program("fit", folder / f"{case}.csv").json
            mine = list(corners(got["cx"], got["cy"], 2 * got["a"], 2 * got["b"],
                                got["angle_deg"]))
            error = sum(min(math.dist(one, other) for other in corners(*expected[case]))
                        for one in mine)
            print(case, "sum of the corners' distances", error, "px")
            self.assertLess(error, 0.01, case)

    def test_near_circle(self):
        for count in (200, 360, 1000):
            points = csv(ellipse_points(27, 27, 17, 16.5, 0, count))
            got = self.run_program("fit", "-", stdin=points.encode()).json
            self.assertLess(math.hypot(got["cx"] - 27, got["cy"] - 27), 0.01)

    def test_five_points_of_a_circle(self):
        got = self.run_program("fit", "-", stdin=b"0,0\n1,1\n1,-1\n-1,1\n-1,-1\n").json
        self.assertLess(math.hypot(got["cx"], got["cy"]), 0.01)
        self.assertAlmostEqual(2 * got["a"], 2 * math.sqrt(2), delta=0.4)
        self.assertAlmostEqual(2 * got["b"], 2 * math.sqrt(2), delta=0.4)


class Answers(ProgramTest):
    def test_fields_and_values(self):
        self.write("p.csv", csv(ellipse_points(100.5, 50.25, 30, 20, 35, 64)))
        for method in ("b2ac", "lcse", "hyper"):
            answer = self.run_program("fit", "--method", method, "p.csv")
            got = answer.json
            self.assertEqual((answer.code, got["status"], answer.err), (0, "ok", ""))
            self.assertEqual(list(got), FIELDS)
            self.assertEqual((got["method"], got["n"]), (method, 64))
            for name, value in (("cx", 100.5), ("cy", 50.25), ("a", 30), ("b", 20),
                                ("angle_deg", 35), ("rms_px", 0)):
                self.assertAlmostEqual(got[name], value, delta=0.02, msg=f"{method} {name}")

    def test_perturb_always_and_never(self):
        self.write("p.csv", csv(ellipse_points(100.5, 50.25, 30, 20, 35, 64)))
        for when, expected in (("always", True), ("never", False)):
            got = self.run_program("fit", "--method", "lcse", "--perturb", when, "p.csv").json
            self.assertIs(got["perturbed"], expected)

    def run_twice(self, points):
        answers = [self.run_program("fit", "-", stdin=points.encode()) for _ in range(2)]
        self.assertEqual(answers[0].out, answers[1].out)
        return answers[0]

    def assert_status(self, points, *statuses):
        answer = self.run_twice(points)
        self.assertIn(answer.json["status"], statuses)
        self.assertEqual(answer.code, 1)
        self.assertEqual(list(answer.json), ["status", "method", "n"])

    def test_degenerate_points_have_a_status(self):
        self.assert_status("1,1\n2,2\n3,3\n4,4\n", "too_few_points")
        self.assert_status("# none\n", "too_few_points")
        self.assert_status("x,y\n", "too_few_points")
        self.assert_status("".join(f"{i},{2 * i}\n" for i in range(9)), "degenerate")
        self.assert_status("7,7\n" * 9, "degenerate")
        self.assert_status("7,7\n8,9\n" * 9, "degenerate")
        self.assert_status("".join(f"{x},{x * x / 10}\n" for x in range(-9, 10)), "degenerate",
                           "not_an_ellipse")

    def test_four_points_on_a_line_and_one_beside_are_never_ok(self):
        self.assertEqual(self.run_twice("0,1\n0,2\n0,3\n2,3\n0,4\n").code, 1)

    def test_points_out_of_range(self):
        self.assert_status("20000,1\n1,2\n3,4\n5,7\n9,9\n", "out_of_range")
        answer = self.run_program("fit", "-", stdin=b"1,1\n-1e9,1\n1,2\n3,4\n5,7\n9,9\n")
        self.assertEqual((answer.code, answer.json["status"]), (1, "out_of_range"))
        self.assertIn("<stdin>:2:1: x = -1e9 is out of range", answer.err)

    def test_too_many_points_overflow(self):
        self.assert_status(csv(ellipse_points(0, 0, 90, 80, 0, 16385)), "overflow")

    def test_all_ways_to_write_a_file(self):
        points = list(ellipse_points(10, 20, 9, 5, 20, 12))
        plain = csv(points)
        scientific = "".join(f"{x:.18e} , {y:.18e}\n" for x, y in points)
        expected = self.run_program("fit", "-", stdin=plain.encode()).out
        for text in ("x,y\n" + plain, "# points\n\n X , Y\n" + plain, plain.replace("\n", "\r\n"),
                     "\ufeffx,y\r\n" + plain, plain.rstrip("\n"), "\n  # one\n" + scientific):
            answer = self.run_program("fit", "-", stdin=text.encode())
            self.assertEqual((answer.out, answer.err), (expected, ""))


class BadFiles(ProgramTest):
    def assert_bad_csv(self, content, *parts):
        self.write("bad.csv", content)
        self.assert_refused(self.run_program("fit", "bad.csv"), *parts)

    def test_a_word(self):
        self.assert_bad_csv("1,2\n# fine\n3,apple\n", "bad.csv:3:3: found 'apple'", "y should be",
                            "a decimal number")
        self.assert_bad_csv("1,2\nx,y\n", "bad.csv:2:1: found 'x'")
        self.assert_bad_csv("x,y\nx,y\n", "bad.csv:2:1: found 'x'")
        self.assert_bad_csv("1,2\n  nan,3\n", "bad.csv:2:3: found 'nan'")

    def test_wrong_number_of_values(self):
        self.assert_bad_csv("1,2\n3\n", "bad.csv:2:1: found 1 value in '3'", "expected two, x,y")
        self.assert_bad_csv("1,2,3\n", "bad.csv:1:5: found 3 values")
        self.assert_bad_csv("1;2\n", "bad.csv:1:1", "with a comma")
        self.assert_bad_csv("1,\n", "bad.csv:1:3: found nothing where y should be")

    def test_binary_rubbish_is_quoted(self):
        self.assert_bad_csv(b"\x00\x01\xff,\x1b[31m\n", "bad.csv:1:1: found '\\x00\\x01\\xff'")

    def test_files_that_cannot_be_read(self):
        self.assert_bad_csv("", "bad.csv: is empty")
        self.assert_refused(self.run_program("fit", "none.csv"), "none.csv: cannot be opened",
                            "No such file")
        self.assert_refused(self.run_program("fit", "."), ".: is a directory")
        self.assert_refused(self.run_program("fit", "-"), "<stdin>: is empty")
