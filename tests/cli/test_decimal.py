# SPDX-License-Identifier: MIT
"""Decimal text to fixed point and back, against exact fractions."""

import fractions
import os
import random
import subprocess
import unittest

SEED = 20240607


def q16_of(text):
    """To nearest, ties to even: Python's round of a fraction."""
    return round(fractions.Fraction(text) * 65536)


def probe(texts, *arguments):
    finished = subprocess.run([os.environ["DECIMAL_PROBE"], *arguments],
                              input="\n".join(texts) + "\n", capture_output=True, text=True,
                              check=True)
    return finished.stdout.splitlines()


def random_decimal(rng):
    digits = rng.choice([1, 3, 6, 17, 40])
    text = rng.choice(["", "-", "+"]) + str(rng.randrange(32767))
    text += rng.choice(["", "." + "".join(rng.choices("0123456789", k=digits))])
    return text + rng.choice(["", "", "e-2", "E-05", "e+0"])


class Decimal(unittest.TestCase):
    def test_random_decimals_are_exact(self):
        print("seed", SEED)
        rng = random.Random(SEED)
        texts = [random_decimal(rng) for _ in range(5000)]
        for text, line in zip(texts, probe(texts)):
            self.assertEqual(int(line.split()[0]), q16_of(text), text)

    def test_ties_go_to_even_and_a_hair_more_goes_up(self):
        half = "0.00000762939453125"  # half of 1/65536
        self.assertEqual([int(line.split()[0]) for line in probe(
            [half, half + "1", "0.00002288818359375", "-" + half, half[:-1]])], [0, 1, 2, 0, 0])

    def test_every_way_to_write_a_number(self):
        texts = ["12", "12.", ".5", "-.5", "+1.5", "1.2e1", "120E-1", "0", "-0", "0000012",
                 "0.0000000000001e13", "1e-400"]
        expected = [12, 12, 0.5, -0.5, 1.5, 12, 12, 0, 0, 12, 1, 0]
        self.assertEqual([int(line.split()[0]) for line in probe(texts)],
                         [int(value * 65536) for value in expected])

    def test_words_are_no_numbers(self):
        texts = ["", "x", "1x", "1 2", ".", "-", "+-1", "1e", "1e+", "nan", "inf", "0x10", "1.2.3",
                 "1,5", "--1", "e5"]
        self.assertEqual(probe(texts), ["word"] * len(texts))

    def test_what_q16_cannot_hold_is_saturated(self):
        largest = 2**31 - 1
        lines = probe(["32767.9999", "32768", "-32768", "1e9", "-1e99999999999", "99999", "100000"])
        self.assertEqual([line.endswith("large") for line in lines],
                         [False, True, True, True, True, True, True])
        self.assertEqual([int(line.split()[0]) for line in lines[1:]],
                         [largest, -largest, largest, -largest, largest, largest])

    def test_text_of_q16_is_the_nearest_millionth(self):
        rng = random.Random(SEED)
        values = [rng.randrange(-2**31 + 1, 2**31) for _ in range(2000)]
        exact = [fractions.Fraction(value, 65536) for value in values]
        texts = [f"{float(value):.20f}" for value in exact]  # Q16 is exact in a double
        for value, line in zip(exact, probe(texts)):
            error = abs(fractions.Fraction(line.split()[1]) - value)
            self.assertLessEqual(error, fractions.Fraction(1, 2000000))


class Length(unittest.TestCase):
    def test_twenty_bits_of_any_unit(self):
        rng = random.Random(SEED)
        texts = ["35", "33.1", ".0331", "3.5e-2", "1", "1e9", "0.000000001", "524288", "524287",
                 "1048575", "1048576", "999999999", "1.99999999999999999999"]
        texts += [f"{rng.uniform(1, 10):.{rng.randrange(18)}f}e{rng.randrange(-9, 9)}"
                  for _ in range(2000)]
        for text, line in zip(texts, probe(texts, "length")):
            count, log2, printed = line.split()
            count, unit = int(count), fractions.Fraction(2) ** int(log2)
            self.assertTrue(2**19 <= count <= 2**20, text)
            self.assertLessEqual(abs(fractions.Fraction(text) / unit - count),
                                 fractions.Fraction(501, 1000), text)
            thousand = 1000 * count * unit
            error = abs(fractions.Fraction(printed) - thousand)
            self.assertLessEqual(error, unit / 2 + thousand / 10**15 if unit < 1 else 1, text)

    def test_what_is_no_length(self):
        self.assertEqual(probe(["0", "0.0", "-1", "1e-10", "1e11", "1e999999", "-0"], "length"),
                         ["large"] * 7)
        self.assertEqual(probe(["", "x", "35mm", "1,5", "nan"], "length"), ["word"] * 5)
