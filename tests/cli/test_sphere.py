# SPDX-License-Identifier: MIT
"""A ball in space: ocellus sphere on points of its outline, ocellus detect on pictures
of it, and what both say of cameras and radii that are none."""

import math

from pictures import COLOUR, png, read_png
from program import ProgramTest

FOCAL, CX, CY = 257.34, 160, 120
CAMERA = f"{FOCAL},{FOCAL},{CX},{CY}"
FIELDS = ["status", "x", "y", "z", "inliers", "n", "rms_px", "arc_coverage", "sigma"]
DETECT_FIELDS = ["status", "method", "blob", "ellipse", "arc_coverage", "rms_px", "sphere"]
ORANGE = "rgb:150-255,60-160,0-60"

# Centre, radius; ellipse centre, semi-axes, angle: the vectors of the iCub's eye.
VECTORS = (((.1, 0, .4), .0331, (224.7786, 120, 22.0303, 21.3682, 0)),
           ((.1, .06, .3), .0331, (246.8371, 172.1023, 30.6749, 28.5676, 30.964)))


def rays(centre, radius, count, arc_deg=360.0):
    """Unit vectors that touch the ball."""
    distance = math.dist(centre, (0, 0, 0))
    sine = radius / distance
    n = [v / distance for v in centre]
    u = [-n[0] * n[1], 1 - n[1] * n[1], -n[2] * n[1]]
    length = math.hypot(*u)
    u = [v / length for v in u]
    v = [n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]]
    for i in range(count):
        t = math.radians(arc_deg) * i / count
        yield [math.sqrt(1 - sine * sine) * n[k] + sine * (u[k] * math.cos(t) + v[k] * math.sin(t))
               for k in range(3)]


def seen(ray, lens=(0, 0, 0, 0, 0), fx=FOCAL, fy=FOCAL):
    """Where the camera sees a ray: OpenCV's model."""
    k1, k2, p1, p2, k3 = lens
    x, y = ray[0] / ray[2], ray[1] / ray[2]
    s = x * x + y * y
    f = 1 + s * (k1 + s * (k2 + s * k3))
    return (fx * (x * f + 2 * p1 * x * y + p2 * (s + 2 * x * x)) + CX,
            fy * (y * f + p1 * (s + 2 * y * y) + 2 * p2 * x * y) + CY)


def csv(points):
    return "".join(f"{x:.9f},{y:.9f}\n" for x, y in points)


def picture(centre, radius, hidden=lambda x, y: False, width=320, height=240):
    """Rows of R, G, B of an orange ball: the pixels whose ray meets it."""
    square = sum(v * v for v in centre) - radius * radius
    rows = []
    for y in range(height):
        row = []
        for x in range(width):
            d = ((x - CX) / FOCAL, (y - CY) / FOCAL, 1)
            along = sum(a * b for a, b in zip(d, centre))
            hit = along > 0 and along * along >= square * sum(v * v for v in d)
            row += [230, 110, 30] if hit and not hidden(x, y) else [60, 80, 90]
        rows.append(row)
    return rows


class SphereTest(ProgramTest):
    def sphere(self, points, radius, *extra, camera=CAMERA):
        return self.run_program("sphere", "--camera", camera, "--radius", radius, *extra, "-",
                                stdin=csv(points).encode())

    def assert_centre(self, got, centre, tolerance):
        """Within `tolerance` of the range."""
        error = math.dist((got["x"], got["y"], got["z"]), centre)
        self.assertLess(error, tolerance * math.dist(centre, (0, 0, 0)), got)


class Points(SphereTest):
    def test_vectors_end_to_end(self):
        for centre, radius, _ in VECTORS:
            answer = self.sphere([seen(ray) for ray in rays(centre, radius, 64)], radius)
            got = answer.json
            self.assertEqual((answer.code, got["status"], answer.err), (0, "ok", ""))
            self.assertEqual(list(got), FIELDS)
            self.assert_centre(got, centre, 3e-5)
            self.assertEqual((got["inliers"], got["n"]), (64, 64))
            self.assertLess(got["rms_px"], 0.001)
            self.assertGreater(got["arc_coverage"], 0.98)
            self.assertEqual(list(got["sigma"]), ["x", "y", "z"])

    def test_the_vectors_ellipses(self):
        for centre, radius, (cx, cy, a, b, angle) in VECTORS:
            turn = math.radians(angle)
            points = [(cx + a * math.cos(t) * math.cos(turn) - b * math.sin(t) * math.sin(turn),
                       cy + a * math.cos(t) * math.sin(turn) + b * math.sin(t) * math.cos(turn))
                      for t in (math.tau * i / 64 for i in range(64))]
            self.assert_centre(self.sphere(points, radius).json, centre, 3e-5)

    def test_any_unit_of_length(self):
        centre, radius, _ = VECTORS[1]
        points = [seen(ray) for ray in rays(centre, radius, 64)]
        for unit in (1e-6, 1, 1000, 39.37, 1e9):
            got = self.sphere(points, repr(radius * unit)).json
            self.assert_centre(got, [v * unit for v in centre], 3e-5)
            # Six significant decimals at least.
            self.assertGreater(got["sigma"]["z"], 0)
            self.assertLess(got["sigma"]["z"], 1e-4 * got["z"])

    def test_points_in_any_order_and_through_a_lens(self):
        centre, radius, lens = (.1, .06, .3), .0331, (-.35, .12, .002, -.001, .01)
        points = [seen(ray, lens) for ray in rays(centre, radius, 90)]
        text = ",".join(map(repr, lens))
        got = self.sphere(points, radius, "--distortion", text).json
        self.assertEqual(got["status"], "ok")
        self.assert_centre(got, centre, 2e-5)
        # Four numbers: k3 is 0.  Without the lens the place is another.
        points = [seen(ray, lens[:4] + (0,)) for ray in rays(centre, radius, 90)]
        got = self.sphere(points[::-1], radius, "--distortion", text.rsplit(",", 1)[0]).json
        self.assert_centre(got, centre, 2e-5)
        blind = self.sphere(points, radius).json
        self.assertGreater(math.dist((blind["x"], blind["y"], blind["z"]), centre), .005)

    def test_pixels_that_are_not_square(self):
        centre, radius = (-.1, .06, .3), .0331
        points = [seen(ray, fx=208.5, fy=156.4) for ray in rays(centre, radius, 64)]
        got = self.sphere(points, radius, camera=f"208.5,156.4,{CX},{CY}").json
        self.assert_centre(got, centre, 2e-5)

    def test_what_hides_a_part_is_left_out(self):
        centre, radius = (.05, 0, .3), .0331
        points = [seen(ray) for ray in rays(centre, radius, 200, 200.0)]
        chord = [(points[-1][0] + (points[0][0] - points[-1][0]) * i / 100,
                  points[-1][1] + (points[0][1] - points[-1][1]) * i / 100) for i in range(1, 100)]
        got = self.sphere(points + chord, radius).json
        self.assertEqual(got["status"], "ok")
        self.assertLess(abs(got["inliers"] - 200), 12)
        self.assertEqual(got["n"], 299)
        self.assert_centre(got, centre, .01)

    def test_a_short_arc_is_an_estimate(self):
        arc = [seen(ray) for ray in rays((.05, 0, .3), .0331, 30, 60.0)]
        points = [(x + .3 * (-1) ** i, y) for i, (x, y) in enumerate(arc)]
        answer = self.sphere(points, .0331)
        self.assertEqual((answer.code, answer.json["status"]), (1, "partial"))
        self.assertEqual(list(answer.json), FIELDS)

    def test_other_statuses_have_no_centre(self):
        line = [(i, 2 * i) for i in range(20)]
        for points, status in ((line[:1], "too_few_points"), (line[:4], "too_few_points"),
                               (line, "degenerate"), ([(5, 5)] * 9, "degenerate"),
                               ([(16000, y) for y in range(9)], "out_of_range"),
                               ([(1e5, y) for y in range(9)], "out_of_range"),
                               (line * 820, "overflow")):
            answer = self.sphere(points, 35)
            self.assertEqual((answer.code, answer.json),
                             (1, {"status": status, "n": len(points)}), answer.err)

    def test_a_ball_too_far_away_for_its_radius(self):
        points = [(160 + .5 * math.cos(i), 120 + .5 * math.sin(i)) for i in range(40)]
        answer = self.sphere(points, 35, camera=f"16000,16000,{CX},{CY}")
        self.assertEqual(answer.code, 1)
        self.assertEqual(list(answer.json), ["status", "n"])


class Detect(SphereTest):
    CENTRE, RADIUS = (12.0, -8.0, 220.0), 35.0

    def detect(self, *extra, image="ball.png"):
        return self.run_program("detect", "--colour", ORANGE, *extra, image)

    def placed(self, *extra, image="ball.png", radius=RADIUS):
        return self.detect("--camera", CAMERA, "--radius", radius, *extra, image=image)

    def setUp(self):
        super().setUp()
        self.write("ball.png", png(picture(self.CENTRE, self.RADIUS), COLOUR))
        self.edge = CX + FOCAL * self.CENTRE[0] / self.CENTRE[2]
        self.write("half.png", png(picture(self.CENTRE, self.RADIUS,
                                           lambda x, y: x > self.edge + 5), COLOUR))

    def test_a_ball_is_placed(self):
        answer = self.placed()
        got = answer.json
        self.assertEqual((answer.code, got["status"], got["method"]), (0, "ok", "sphere"))
        self.assertEqual(list(got), DETECT_FIELDS)
        self.assertEqual(list(got["sphere"]), ["x", "y", "z", "inliers", "sigma"])
        self.assert_centre(got["sphere"], self.CENTRE, 2e-3)
        self.assertAlmostEqual(got["ellipse"]["a"], FOCAL * 35 / 220, delta=1.5)
        self.assertEqual(self.placed("--method", "sphere").out, answer.out)

    def test_half_of_it_hidden(self):
        whole, half = self.placed().json, self.placed(image="half.png").json
        self.assertEqual(half["status"], "ok")
        self.assert_centre(half["sphere"], self.CENTRE, 5e-3)
        self.assertLess(half["arc_coverage"], .75)
        self.assertLess(half["sphere"]["inliers"], .7 * whole["sphere"]["inliers"])
        for name in ("cx", "cy", "a", "b"):
            self.assertAlmostEqual(half["ellipse"][name], whole["ellipse"][name], delta=.5)
        self.assertGreater(half["sphere"]["sigma"]["z"], whole["sphere"]["sigma"]["z"])

    def test_other_methods_place_by_the_ellipse(self):
        plain = self.detect().json
        for method in ("b2ac", "lcse", "hyper"):
            got = self.placed("--method", method).json
            self.assertEqual(got["method"], method)
            self.assert_centre(got["sphere"], self.CENTRE, 4e-3)
        got = self.placed("--method", "b2ac").json
        del got["sphere"]
        self.assertEqual(got, plain)
        # What the ellipse cannot: half of it hidden.
        half = self.placed("--method", "b2ac", image="half.png").json
        if "sphere" in half:
            place = [half["sphere"][name] for name in "xyz"]
            self.assertGreater(math.dist(place, self.CENTRE), 10)

    def test_cut_by_the_edge(self):
        self.write("cut.png", png(picture((-138.0, 0.0, 220.0), 35.0), COLOUR))
        answer = self.placed(image="cut.png")
        got = answer.json
        self.assertIn((answer.code, got["status"]), ((0, "ok"), (1, "clipped")))
        if answer.code == 0:
            self.assert_centre(got["sphere"], (-138.0, 0.0, 220.0), .05)

    def test_a_covered_camera_and_an_empty_room(self):
        self.write("full.png", png([[230, 110, 30] * 32] * 24, COLOUR))
        self.write("empty.png", png([[60, 80, 90] * 32] * 24, COLOUR))
        answer = self.placed(image="full.png")
        self.assertEqual((answer.code, list(answer.json)), (1, ["status", "method", "blob"]))
        self.assertEqual(answer.json["status"], "clipped")
        answer = self.placed(image="empty.png")
        self.assertEqual((answer.code, answer.json),
                         (1, {"status": "not_seen", "method": "sphere"}))

    def test_a_lens_is_undone_and_drawn(self):
        got = self.placed("--distortion", "-0.3,0.1,0,0", "--annotate", "out.png").json
        self.assertEqual(got["status"], "ok")
        _, _, rows = read_png((self.folder / "out.png").read_bytes())
        y, x = round(CY - 8 * FOCAL / 220), round(self.edge + FOCAL * 35 / 220)
        greens = [rows[y][3 * i + 1] - max(rows[y][3 * i], rows[y][3 * i + 2])
                  for i in range(x - 3, x + 4)]
        self.assertGreater(max(greens), 80)

    def test_picture_of_the_outline_and_its_inliers(self):
        self.placed("--annotate", "out.png", image="half.png")
        _, _, rows = read_png((self.folder / "out.png").read_bytes())
        y, x = round(CY - 8 * FOCAL / 220), round(self.edge + FOCAL * 35 / 220)
        greens = [rows[y][3 * i + 1] - max(rows[y][3 * i], rows[y][3 * i + 2])
                  for i in range(x - 1, x + 2)]  # the hidden side, a line one pixel wide
        self.assertGreater(max(greens), 60)
        blob = self.placed(image="half.png").json["blob"]
        below = rows[blob["top"] + blob["height"] + 4:blob["top"] + blob["height"] + 15]
        whites = sum(row[3 * i:3 * i + 3] == [255, 255, 255]
                     for row in below for i in range(blob["left"], blob["left"] + 60))
        self.assertGreater(whites, 100)
        plain = self.detect("--annotate", "plain.png", image="half.png")
        self.assertEqual(plain.json["method"], "b2ac")
        _, _, rows = read_png((self.folder / "plain.png").read_bytes())
        below = rows[blob["top"] + blob["height"] + 4:blob["top"] + blob["height"] + 15]
        self.assertEqual(sum(row[3 * i:3 * i + 3] == [255, 255, 255] for row in below
                             for i in range(blob["left"], blob["left"] + 60)), 0)


class Refused(SphereTest):
    def setUp(self):
        super().setUp()
        self.write("p.csv", csv(seen(ray) for ray in rays((.1, 0, .4), .0331, 20)))
        self.write("ball.png", png([[230, 110, 30] * 32] * 24, COLOUR))

    def commands(self, *options):
        yield self.run_program("sphere", *options, "p.csv")
        yield self.run_program("detect", "--colour", ORANGE, *options, "ball.png")

    def test_bad_cameras_and_radii(self):
        for camera, parts in (("0,257,160,120", ["fx is 0", "16 to 16384 px"]),
                              ("257,-257,160,120", ["fy is -257"]),
                              ("257,1e9,160,120", ["fy is 1e9"]),
                              ("257,257,20000,120", ["cx is 20000", "16384"]),
                              ("257,257,160", ["found 3 values", "fx,fy,cx,cy"]),
                              ("257,257,160,120,0", ["found 5 values"]),
                              ("257", ["found 1 value;"]), ("a,b,c,d", ["found 'a' where fx"]),
                              ("257,257,160,", ["found nothing where cy"]),
                              ("257 257 160 120", ["found 1 value;"])):
            for answer in self.commands("--camera", camera, "--radius", "35"):
                self.assert_refused(answer, f"--camera '{camera}'", *parts)
        for radius in ("0", "-35", "1e-30", "1e30", "x", "35mm", "1,5", "nan"):
            for answer in self.commands("--camera", CAMERA, "--radius", radius):
                self.assert_refused(answer, f"--radius '{radius}'", "such as 35")
        for lens, parts in (("1,2,3", ["found 3 values", "k1,k2,p1,p2[,k3]"]),
                            ("a,0,0,0", ["found 'a' where k1"]), ("0,0,17,0", ["p1 is 17"]),
                            ("0,0,0,0,-17", ["k3 is -17", "within +-16"])):
            for answer in self.commands("--camera", CAMERA, "--radius", "35", "--distortion", lens):
                self.assert_refused(answer, f"--distortion '{lens}'", *parts)

    def test_what_is_missing_is_named(self):
        for options, part in ((["--camera", CAMERA], "add --radius R"),
                              (["--radius", "35"], "add --camera fx,fy,cx,cy"),
                              (["--distortion", "0,0,0,0"], "add --camera fx,fy,cx,cy")):
            for answer in self.commands(*options):
                self.assert_refused(answer, part)
        self.assert_refused(self.run_program("sphere", "p.csv"), "add --camera")
        for method in ("sphere", "b2ac"):
            self.assert_refused(self.run_program("detect", "--colour", ORANGE, "--method", method,
                                                 "--camera", CAMERA, "ball.png"), "add --radius")
        self.assert_refused(self.run_program("detect", "--colour", ORANGE, "--method", "sphere",
                                             "ball.png"), "add --camera")
        self.assert_refused(self.run_program("detect", "--colour", ORANGE, "--method", "best",
                                             "ball.png"), "sphere, b2ac, lcse or hyper")

    def test_a_camera_that_sees_nothing_of_the_image(self):
        answer = self.run_program("detect", "--colour", ORANGE, "--camera", "16,16,-9000,0",
                                  "--radius", "35", "ball.png")
        self.assert_refused(answer, "--camera", "32 x 24")
