#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes frame.h: a small RGB565 frame with a ball whose place is known.

usage: frame.py >frame.h
"""
WIDTH, HEIGHT, CX, CY, RADIUS = 48, 36, 27.25, 16.75, 10.5


def noise(x, y):
    value = (x * 0x9E3779B1 ^ y * 0x85EBCA77) & 0xFFFFFFFF
    value = ((value ^ (value >> 15)) * 0x2C1B3C6D) & 0xFFFFFFFF
    return (value >> 24) % 9


def pixel(x, y):
    ball = (x - CX) ** 2 + (y - CY) ** 2 <= RADIUS ** 2
    red, green, blue = (221, 101, 31) if ball else (60 + x, 80 + y, 110)
    red, green, blue = (channel + noise(x, y) for channel in (red, green, blue))
    return (red >> 3) << 11 | (green >> 2) << 5 | blue >> 3


def main():
    print("/* SPDX-License-Identifier: MIT\n *\n"
          " * A camera's frame, RGB565, with an orange ball.  Written by frame.py.\n */")
    print("#ifndef VENDOR_FRAME_H\n#define VENDOR_FRAME_H\n\n#include <stdint.h>\n")
    print(f"enum {{ FRAME_WIDTH = {WIDTH}, FRAME_HEIGHT = {HEIGHT} }};\n")
    for name, value in (("CX", CX), ("CY", CY), ("RADIUS", RADIUS)):
        print(f"#define FRAME_BALL_{name}_Q16 {int(value * 65536)}")
    print("\n/* clang-format off */")
    print("static const uint16_t frame_pixels[FRAME_WIDTH * FRAME_HEIGHT] = {")
    for y in range(HEIGHT):
        for first in range(0, WIDTH, 12):
            print("    " + " ".join(f"0x{pixel(x, y):04x}," for x in range(first, first + 12)))
    print("};\n/* clang-format on */\n\n#endif")


main()
