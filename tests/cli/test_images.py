# SPDX-License-Identifier: MIT
"""Every picture format in, through `ocellus label`, and every way to break one."""

import random

from pictures import COLOUR, COLOUR_ALPHA, GREY, PALETTE, pgm, png, ppm
from program import ProgramTest

SEED = 99
MASK = ["..#....#.", ".........", "###...##.", "..#....#.", "........#"]
COUNT = 4
ROWS = [[1 if c == "#" else 0 for c in row] for row in MASK]


def mapped(rows, values):
    """Each sample replaced by a tuple of samples."""
    return [[s for sample in row for s in values[sample]] for row in rows]


class Formats(ProgramTest):
    def setUp(self):
        super().setUp()
        self.expected = self.run_program("label", "-", stdin=pgm(ROWS)).out
        self.assertIn(f'"count":{COUNT}', self.expected)

    def assert_same(self, data, message=""):
        answer = self.run_program("label", "-", stdin=data)
        self.assertEqual((answer.code, answer.out), (0, self.expected), answer.err)
        self.assertIn(message, answer.err)
        self.assertEqual(bool(message), bool(answer.err), answer.err)

    def test_png(self):
        self.assert_same(png(ROWS))
        for depth in (1, 2, 4, 8, 16):
            self.assert_same(png(ROWS, depth=depth))
        self.assert_same(png(mapped(ROWS, {0: (0, 0, 0), 1: (0, 0, 9)}), COLOUR))
        self.assert_same(png(mapped(ROWS, {0: (0, 0, 0), 1: (0, 1, 0)}), COLOUR, 16))
        for depth in (1, 2, 4, 8):
            self.assert_same(png(ROWS, PALETTE, depth, palette=[0, 0, 0, 200, 10, 10]))

    def test_interlaced_png(self):
        self.assert_same(png(ROWS, interlaced=True))
        self.assert_same(png(mapped(ROWS, {0: (0, 0, 0), 1: (7, 7, 7)}), COLOUR, interlaced=True))

    def test_transparency_is_dropped_and_said(self):
        opaque = {0: (0, 0, 0, 255), 1: (5, 5, 5, 0)}
        self.assert_same(png(mapped(ROWS, opaque), COLOUR_ALPHA), "transparency is dropped")

    def test_binary_netpbm(self):
        self.assert_same(pgm(ROWS, 1))
        self.assert_same(pgm(ROWS, 65535))
        self.assert_same(ppm(mapped(ROWS, {0: (0, 0, 0), 1: (0, 0, 1)})))
        bits = b"".join(int("".join(map(str, row)) + "0" * 7, 2).to_bytes(2, "big") for row in ROWS)
        self.assert_same(b"P4 9 5\n" + bits)

    def test_plain_netpbm(self):
        words = "\n".join(" ".join(map(str, row)) for row in ROWS)
        self.assert_same(f"P2 # a comment\n9 5 # another\n1\n{words}".encode())
        self.assert_same(f"P1\n9 5\n{words}\n".encode())
        self.assert_same(f"P1\n9 5\n{words.replace(' ', '')}\n".encode())
        triples = words.replace("1", "0 3 0").replace("0 ", "0 0 0 ")
        self.assertIn("0 3 0", triples)
        colour = mapped(ROWS, {0: (0, 0, 0), 1: (0, 3, 0)})
        self.assert_same(f"P3 9 5 255 {' '.join(str(s) for row in colour for s in row)}".encode())

    def test_what_follows_a_picture_is_said(self):
        self.assert_same(pgm(ROWS) + b"P5 ", "3 bytes after the first picture")


class Broken(ProgramTest):
    def assert_bad(self, data, *parts):
        self.write("bad.png", data)
        self.assert_refused(self.run_program("label", "bad.png"), "bad.png", *parts)

    def test_no_picture(self):
        self.assert_bad(b"just words\n", "bad.png:1: found a file that starts with 'just wor'",
                        "expected a PNG, PGM or PPM")
        self.assert_bad(b"\xff\xd8\xff\xe0 and so on", "found a JPEG", "convert it to PNG")
        self.assert_bad(b"", "is empty")
        self.assert_bad(b"P", "expected a PNG, PGM or PPM")
        self.assert_bad(b"\x89PNG\r\n\x1a\n", "a damaged or truncated PNG")

    def test_missing(self):
        self.assert_refused(self.run_program("label", "none.png"), "none.png: cannot be opened")

    def test_truncated_png_wherever_it_ends(self):
        whole = png([[random.Random(SEED + y).randrange(256) for _ in range(40)] for y in range(9)])
        for length in list(range(8, 60)) + list(range(60, len(whole), 37)) + [len(whole) - 1]:
            self.assert_bad(whole[:length], "a damaged or truncated PNG",
                            "expected a whole PNG")

    def test_damaged_png_never_crashes(self):
        print("seed", SEED)
        rng = random.Random(SEED)
        whole = png([[rng.randrange(256) for _ in range(20)] for _ in range(9)])
        for _ in range(150):
            damaged = bytearray(whole)
            damaged[rng.randrange(8, len(whole) - 12)] ^= 1 << rng.randrange(8)
            self.write("bad.png", bytes(damaged))
            answer = self.run_program("label", "bad.png")
            self.assertTrue(answer.code == 2 or answer.out, answer.err)

    def test_too_large(self):
        self.assert_bad(png([[0] * 4097]), "4097 x 1", "too large", "4096 x 4096")
        self.assert_bad(b"P5 1 4097 255\n" + bytes(4097), "1 x 4097", "too large")
        self.assert_bad(b"P5 0 5 255\n", "0 x 5", "at least one pixel")
        self.assert_bad(b"P5 99999999999 5 255\n", "bad.png:1: found '99999999999'")

    def test_truncated_netpbm(self):
        self.assert_bad(b"P5\n10 10\n255\n" + bytes(99), "bad.png:4: a truncated picture",
                        "found 99 bytes", "expected 100")
        self.assert_bad(b"P2\n2 2\n255\n1 2\n3\n", "bad.png:6: the file ends where a sample")
        self.assert_bad(b"P4\n9 2\n" + bytes(3), "expected 4")
        self.assert_bad(b"P1\n2 2\n101", "the file ends where a pixel")
        self.assert_bad(b"P5\n10", "the file ends where the height")

    def test_wrong_netpbm(self):
        self.assert_bad(b"P2\n2 2\n255\n1 2\n3 x\n", "bad.png:5: found 'x' where a sample")
        self.assert_bad(b"P2\n2 1\n15\n1 16\n", "bad.png:4: found the sample 16", "at most 15")
        self.assert_bad(b"P5\n2 1\n0\n..", "found 0 as the largest sample", "1..65535")
        self.assert_bad(b"P5\ntwo 1\n255\n..", "bad.png:2: found 'two' where the width")
        self.assert_bad(b"P1\n2 1\n1 2\n", "found '2' where a pixel", "0 or 1")
