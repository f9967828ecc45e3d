# SPDX-License-Identifier: MIT
"""ocellus detect: a rendered ball, its fields for each status, teaching, pictures.
The ball in space is test_sphere.py's."""

import math

from pictures import COLOUR, ball, channel, pgm, png, ppm, read_png
from program import ProgramTest

ORANGE = "hsv:5-45,120-255,60-255"
BALL = (80.37, 60.81, 30.3)  # centre and radius in a 160 x 120 picture
ROWS = ball(160, 120, *BALL)
FIELDS = ["status", "method", "blob", "ellipse", "arc_coverage", "rms_px"]
BLOB_FIELDS = ["left", "top", "width", "height", "area", "cx", "cy"]


class DetectTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("ball.png", png(ROWS, COLOUR))
        self.write("empty.png", png([[60, 80, 90] * 40] * 30, COLOUR))

    def assert_ball(self, answer):
        got = answer.json
        self.assertEqual((answer.code, got["status"]), (0, "ok"), answer.err)
        ellipse = got["ellipse"]
        error = math.hypot(ellipse["cx"] - BALL[0], ellipse["cy"] - BALL[1])
        self.assertLess(error, 0.1)
        self.assertAlmostEqual(ellipse["a"], BALL[2], delta=0.5)
        self.assertAlmostEqual(ellipse["b"], BALL[2], delta=0.5)
        return got


class Found(DetectTest):
    def test_ball_and_fields(self):
        got = self.assert_ball(self.run_program("detect", "--colour", ORANGE, "ball.png"))
        self.assertEqual(list(got), FIELDS)
        self.assertEqual(list(got["blob"]), BLOB_FIELDS)
        self.assertEqual(list(got["ellipse"]), ["cx", "cy", "a", "b", "angle_deg"])
        self.assertEqual(got["method"], "b2ac")
        self.assertGreater(got["arc_coverage"], 0.98)
        self.assertLess(got["rms_px"], 0.5)

    def test_every_method(self):
        for method in ("b2ac", "lcse", "hyper"):
            answer = self.run_program("detect", "--colour", ORANGE, "--method", method, "ball.png")
            self.assertEqual(self.assert_ball(answer)["method"], method)

    def test_every_format(self):
        first = self.run_program("detect", "--colour", ORANGE, "ball.png")
        for name in ("rgb888", "bgr888"):
            answer = self.run_program("detect", "--colour", ORANGE, "--format", name, "ball.png")
            self.assertEqual(answer.out, first.out)
        self.assert_ball(
            self.run_program("detect", "--colour", ORANGE, "--format", "rgb565", "ball.png"))

    def test_every_space(self):
        for spec in ("rgb:145-255,60-160,0-60", "gray:96-255", "yuv:90-200,0-112,140-255"):
            got = self.run_program("detect", "--colour", spec, "ball.png").json
            self.assertEqual(got["status"], "ok", spec)
            self.assertAlmostEqual(got["ellipse"]["cx"], BALL[0], delta=0.1)

    def test_grey_picture_and_stdin(self):
        grey = pgm(channel(ROWS, 0))
        answer = self.run_program("detect", "--colour", "gray:145-255", "-", stdin=grey)
        self.assert_ball(answer)
        for name in ("gray8", "rgb888"):
            again = self.run_program("detect", "--colour", "gray:145-255", "--format", name, "-",
                                     stdin=grey)
            self.assertEqual(again.out, answer.out)

    def test_ppm_and_the_same_run_twice(self):
        first = self.run_program("detect", "--colour", ORANGE, "ball.png")
        second = self.run_program("detect", "--colour", ORANGE, "-", stdin=ppm(ROWS))
        self.assertEqual(first.out, second.out)

    def test_ink_of_a_bitmap_is_dark(self):
        answer = self.run_program("detect", "--colour", "gray:0-9", "--min-area", 1, "-",
                                  stdin=b"P1 4 3 0000 0110 0000")
        self.assertEqual(answer.json["blob"]["area"], 2)

    def test_hue_wraps(self):
        self.write("red.png", png(ball(160, 120, *BALL, colour=(220, 20, 40)), COLOUR))
        self.assert_ball(self.run_program("detect", "--colour", "hsv:340-10,120-255,60-255",
                                          "red.png"))


class OtherStatuses(DetectTest):
    def test_not_seen_has_no_fields(self):
        answer = self.run_program("detect", "--colour", ORANGE, "empty.png")
        self.assertEqual((answer.code, answer.json), (1, {"status": "not_seen", "method": "b2ac"}))

    def test_too_small_is_not_seen(self):
        area = self.run_program("detect", "--colour", ORANGE, "ball.png").json["blob"]["area"]
        for least, status in ((area, "ok"), (area + 1, "not_seen")):
            answer = self.run_program("detect", "--colour", ORANGE, "--min-area", least, "ball.png")
            self.assertEqual(answer.json["status"], status)

    def test_clipped(self):
        self.write("cut.png", png(ball(160, 120, 150.0, 60.0, 30.0), COLOUR))
        answer = self.run_program("detect", "--colour", ORANGE, "cut.png")
        self.assertEqual((answer.code, answer.json["status"]), (1, "clipped"))
        blob = answer.json["blob"]
        self.assertEqual(blob["left"] + blob["width"], 160)
        # An estimate tells its uncertainty; what is vouched for has none to tell.
        self.assertGreater(answer.json["centre_sigma_px"], 0.0)
        self.assertNotIn("centre_sigma_px", self.run_program("detect", "--colour", ORANGE,
                                                             "ball.png").json)

    def test_one_pixel_high_blob_answers(self):
        rows = [[0] * 60 for _ in range(9)]
        rows[4][10:50] = [255] * 40
        answer = self.run_program("detect", "--colour", "gray:9-255", "-", stdin=pgm(rows))
        self.assertEqual(answer.json["blob"]["area"], 40)
        self.assertEqual("ellipse" in answer.json, "rms_px" in answer.json)

    def test_picture_of_one_pixel(self):
        answer = self.run_program("detect", "--colour", "gray:9-255", "--min-area", 1, "-",
                                  stdin=pgm([[255]]))
        self.assertEqual(answer.code, 1)
        self.assertEqual(answer.json["blob"]["area"], 1)


class Teaching(DetectTest):
    def test_round_trip(self):
        for space in ("hsv", "rgb", "yuv", "gray"):
            taught = self.run_program("detect", "--teach", "70,50,16,16", "--teach-space", space,
                                      "ball.png")
            got = self.assert_ball(taught)
            self.assertEqual(list(got), FIELDS + ["colour"])
            self.assertTrue(got["colour"].startswith(space + ":"))
            given = self.run_program("detect", "--colour", got["colour"], "ball.png").json
            del got["colour"]
            self.assertEqual(given, got)

    def test_usual_space(self):
        colour = self.run_program("detect", "--teach", "70,50,16,16", "ball.png").json["colour"]
        self.assertTrue(colour.startswith("hsv:"), colour)
        grey = self.run_program("detect", "--teach", "70,50,16,16", "-",
                                stdin=pgm(channel(ROWS, 0)))
        self.assertTrue(self.assert_ball(grey)["colour"].startswith("gray:"))

    def test_colour_is_learnt_from_the_first_image(self):
        answer = self.run_program("detect", "--teach", "70,50,16,16", "ball.png", "empty.png")
        self.assertEqual([line["status"] for line in answer.lines], ["ok", "not_seen"])
        self.assertEqual(answer.lines[0]["colour"], answer.lines[1]["colour"])

    def test_bad_rectangles(self):
        for text in ("1,2,3", "a,b,c,d", "1,2,0,5", "-1,2,3,4", "1,2,3,4,5", "1 2 3 4",
                     "1.5,2,9,9"):
            self.assert_refused(self.run_program("detect", f"--teach={text}", "ball.png"),
                                "--teach", "expected x,y,w,h")
        self.assert_refused(self.run_program("detect", "--teach", "150,50,11,16", "ball.png"),
                            "reaches out of ball.png", "160 x 120")
        self.assert_refused(self.run_program("detect", "--teach", "70,50,3,5", "ball.png"),
                            "at least 16")
        self.assert_refused(self.run_program("detect", "--teach", "70,50,9,9", "--teach-space",
                                             "lab", "ball.png"), "--teach-space 'lab'")


class Specs(DetectTest):
    def test_bad_specs_are_told_the_grammar(self):
        for spec in ("orange", "rgb", "rgb:", "rgb:1-2,3-4", "rgb:1-2,3-4,5-6,7-8", "rgb:1-2,3-4,5",
                     "rgb:1-2,3-4,9-5", "rgb:1-2,3-4,5-256", "hsv:0-361,0-1,0-1", "HSV:0-1,0-1,0-1",
                     "gray:1-2,3-4", "gray:a-b", "gray:1.5-9", "gray:1-2 ", "gray:-1-5", "gray:5",
                     "hsv:1-2-3,0-1,0-1", "lab:1-2,3-4,5-6", ":1-2", "gray:99999999999-2"):
            self.assert_refused(self.run_program("detect", "--colour", spec, "ball.png"),
                                f"--colour '{spec}'", "rgb:r0-r1,g0-g1,b0-b1", "gray:v0-v1")

    def test_colour_or_teach(self):
        self.assert_refused(self.run_program("detect", "ball.png"), "found neither")
        self.assert_refused(self.run_program("detect", "--colour", ORANGE, "--teach", "1,2,9,9",
                                             "ball.png"), "found both")

    def test_bad_options(self):
        for option, value in (("--method", "best"), ("--connectivity", "6"), ("--format", "nv12"),
                              ("--min-area", "0"), ("--min-area", "-5"), ("--perturb", "maybe"),
                              ("--format", "gray8")):
            self.assert_refused(self.run_program("detect", "--colour", ORANGE, option, value,
                                                 "ball.png"), option)


class Several(DetectTest):
    def test_file_field_and_worst_exit_code(self):
        answer = self.run_program("detect", "--colour", ORANGE, "ball.png", "empty.png")
        self.assertEqual(answer.code, 1)
        self.assertEqual([(line["file"], line["status"]) for line in answer.lines],
                         [("ball.png", "ok"), ("empty.png", "not_seen")])
        swapped = self.run_program("detect", "--colour", ORANGE, "empty.png", "ball.png")
        self.assertEqual((swapped.code, swapped.lines[::-1]), (1, answer.lines))
        alone = self.run_program("detect", "--colour", ORANGE, "ball.png").json
        del answer.lines[0]["file"]
        self.assertEqual(answer.lines[0], alone)

    def test_grey_and_colour_pictures_mix(self):
        self.write("grey.pgm", pgm(channel(ROWS, 1)))
        answer = self.run_program("detect", "--colour", "gray:96-255", "ball.png", "grey.pgm",
                                  "ball.png")
        self.assertEqual(len(answer.lines), 3)
        self.assertEqual(answer.lines[0], answer.lines[2])

    def test_a_bad_file_ends_with_2(self):
        answer = self.run_program("detect", "--colour", ORANGE, "ball.png", "none.png")
        self.assertEqual(answer.code, 2)
        self.assertEqual(len(answer.out.splitlines()), 1)
        self.assertIn("none.png", answer.err)


class Annotating(DetectTest):
    def test_same_size_with_the_outline_in_green(self):
        self.run_program("detect", "--colour", ORANGE, "--annotate", "out.png", "ball.png")
        width, height, rows = read_png((self.folder / "out.png").read_bytes())
        self.assertEqual((width, height), (160, 120))
        x, y = round(BALL[0] + BALL[2]), round(BALL[1])
        red, green, blue = rows[y][3 * x:3 * x + 3]
        self.assertTrue(green > 200 and green > red + 80 and green > blue + 80, rows[y][3 * x - 6:])
        self.assertEqual(rows[5][:12], ROWS[5][:12])  # far from the ball nothing changes

    def test_outline_of_a_tilted_ellipse(self):
        turn = math.radians(30)
        rows = [[0] * 120 for _ in range(100)]
        for y in range(100):
            for x in range(120):
                u = (x - 60) * math.cos(turn) + (y - 50) * math.sin(turn)
                v = (y - 50) * math.cos(turn) - (x - 60) * math.sin(turn)
                rows[y][x] = 200 if (u / 40) ** 2 + (v / 20) ** 2 <= 1 else 0
        answer = self.run_program("detect", "--colour", "gray:100-255", "--annotate", "out.png",
                                  "-", stdin=pgm(rows))
        self.assertAlmostEqual(answer.json["ellipse"]["angle_deg"], 30, delta=0.5)
        _, _, drawn = read_png((self.folder / "out.png").read_bytes())
        for x, y in ((60 + 40 * math.cos(turn), 50 + 40 * math.sin(turn)),
                     (60 + 20 * math.sin(turn), 50 - 20 * math.cos(turn))):
            red, green, _ = drawn[round(y)][3 * round(x):3 * round(x) + 3]
            self.assertTrue(green > 150 and green > red + 80, (x, y))

    def test_estimate_is_not_green(self):
        self.write("cut.png", png(ball(160, 120, 150.0, 60.0, 30.0), COLOUR))
        self.run_program("detect", "--colour", ORANGE, "--annotate", "out.png", "cut.png")
        _, _, rows = read_png((self.folder / "out.png").read_bytes())
        greens = sum(row[i + 1] > 200 and row[i] < 100 for row in rows for i in range(0, 480, 3))
        self.assertEqual(greens, 0)
        self.assertNotEqual(rows, ball(160, 120, 150.0, 60.0, 30.0))

    def test_nothing_found_is_a_plain_copy(self):
        self.run_program("detect", "--colour", ORANGE, "--annotate", "out.png", "empty.png")
        self.assertEqual(read_png((self.folder / "out.png").read_bytes())[2],
                         read_png((self.folder / "empty.png").read_bytes())[2])

    def test_several_into_a_folder(self):
        self.write("other.png", png(ROWS, COLOUR))
        self.assert_refused(self.run_program("detect", "--colour", ORANGE, "--annotate", "out",
                                             "ball.png", "other.png"), "--annotate out", "folder")
        (self.folder / "out").mkdir()
        self.run_program("detect", "--colour", ORANGE, "--annotate", "out", "ball.png", "other.png")
        self.assertEqual(sorted(path.name for path in (self.folder / "out").iterdir()),
                         ["ball.png", "other.png"])

    def test_never_over_the_input_and_never_silently(self):
        before = (self.folder / "ball.png").read_bytes()
        self.assert_refused(self.run_program("detect", "--colour", ORANGE, "--annotate",
                                             "./ball.png", "ball.png"), "is the image itself")
        self.assertEqual((self.folder / "ball.png").read_bytes(), before)
        self.assert_refused(self.run_program("detect", "--colour", ORANGE, "--annotate",
                                             "none/out.png", "ball.png"), "none/out.png",
                            "cannot be written")
