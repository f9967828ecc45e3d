# SPDX-License-Identifier: MIT
"""ocellus label: published cases, and a flood fill as its twin."""

import random

from pictures import pgm
from program import ProgramTest

SEED = 4711
BLOB_FIELDS = ["left", "top", "width", "height", "area", "cx", "cy"]


def flood_fill(mask, connectivity):
    """The components of `mask` in raster order of their first pixels."""
    steps = [(1, 0), (-1, 0), (0, 1), (0, -1)]
    if connectivity == 8:
        steps += [(1, 1), (1, -1), (-1, 1), (-1, -1)]
    height, width = len(mask), len(mask[0])
    seen, blobs = set(), []
    for start in ((x, y) for y in range(height) for x in range(width) if mask[y][x]):
        if start in seen:
            continue
        seen.add(start)
        pixels, waiting = [], [start]
        while waiting:
            x, y = waiting.pop()
            pixels.append((x, y))
            for step_x, step_y in steps:
                u, v = x + step_x, y + step_y
                if (0 <= u < width and 0 <= v < height and mask[v][u] and (u, v) not in seen):
                    seen.add((u, v))
                    waiting.append((u, v))
        blobs.append(pixels)
    return blobs


def blob_of(pixels):
    xs, ys = [x for x, _ in pixels], [y for _, y in pixels]
    return {"left": min(xs), "top": min(ys), "width": max(xs) - min(xs) + 1,
            "height": max(ys) - min(ys) + 1, "area": len(pixels),
            "cx": sum(xs) / len(xs), "cy": sum(ys) / len(ys)}


class LabelTest(ProgramTest):
    def label(self, mask, connectivity=8):
        return self.run_program("label", "--connectivity", connectivity, "-", stdin=pgm(mask))

    def assert_count(self, mask, count, connectivity=8):
        answer = self.label(mask, connectivity)
        self.assertEqual((answer.code, answer.json["status"]), (0, "ok"))
        self.assertEqual(answer.json["count"], count)
        self.assertEqual(len(answer.json["blobs"]), count)
        return answer.json["blobs"]


class Published(LabelTest):
    def test_chessboard(self):
        board = [[255 * ((x + y) % 2) for x in range(16)] for y in range(16)]
        self.assert_count(board, 1, 8)
        self.assert_count(board, 128, 4)

    def test_alternating_row(self):
        self.assert_count([[1 - x % 2 for x in range(15)]], 8)

    def test_no_object_is_not_seen(self):
        answer = self.label([[0] * 31 for _ in range(87)])
        self.assertEqual(answer.code, 1)
        self.assertEqual(answer.json, {"status": "not_seen", "count": 0, "blobs": []})

    def test_full_square(self):
        blobs = self.assert_count([[1] * 10 for _ in range(10)], 1)
        self.assertEqual(blobs, [{"left": 0, "top": 0, "width": 10, "height": 10, "area": 100,
                                  "cx": 4.5, "cy": 4.5}])
        self.assertEqual(list(blobs[0]), BLOB_FIELDS)

    def test_every_second_pixel(self):
        row, gap = [255, 0] * 256, [0] * 512
        blobs = self.assert_count([row, gap] * 256, 65536)
        self.assertEqual({blob["area"] for blob in blobs}, {1})

    def test_comb_is_one_blob(self):
        teeth = [[255 * (x % 2) for x in range(320)] for _ in range(100)]
        blobs = self.assert_count(teeth + [[255] * 320], 1)
        self.assertEqual(blobs[0]["area"], 16320)


class Twin(LabelTest):
    def assert_twin(self, mask, connectivity):
        expected = [blob_of(pixels) for pixels in flood_fill(mask, connectivity)]
        got = self.label(mask, connectivity).json["blobs"]
        self.assertEqual(len(got), len(expected))
        for one, other in zip(got, expected):
            for name in BLOB_FIELDS:
                self.assertAlmostEqual(one[name], other[name], delta=1e-5, msg=name)

    def test_random_masks(self):
        print("seed", SEED)
        rng = random.Random(SEED)
        for width, height in ((1, 1), (1, 9), (31, 7), (32, 8), (33, 9), (64, 20), (97, 60)):
            for share in (0.3, 0.5, 0.7):
                mask = [[int(rng.random() < share) for _ in range(width)] for _ in range(height)]
                for connectivity in (8, 4):
                    self.assert_twin(mask, connectivity)

    def test_widest_and_tallest(self):
        self.assert_twin([[1] * 4096], 8)
        self.assert_twin([[1]] * 4096, 8)


class Usage(LabelTest):
    def test_connectivity(self):
        self.assert_refused(self.label([[1]], 6), "--connectivity '6': expected 8", "or 4")
