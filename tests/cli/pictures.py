# SPDX-License-Identifier: MIT
"""Pictures for the tests, written and read with the standard library only."""

import math
import struct
import zlib

GREY, COLOUR, PALETTE, COLOUR_ALPHA = 0, 2, 3, 6
CHANNELS = {GREY: 1, COLOUR: 3, PALETTE: 1, COLOUR_ALPHA: 4}


def chunk(kind, data):
    return (struct.pack(">I", len(data)) + kind + data +
            struct.pack(">I", zlib.crc32(kind + data)))


def packed_row(samples, depth):
    """Samples of one row as PNG packs them, most significant bit first."""
    if depth == 16:
        return b"".join(struct.pack(">H", s) for s in samples)
    if depth == 8:
        return bytes(samples)
    bits = "".join(format(s, f"0{depth}b") for s in samples)
    bits += "0" * (-len(bits) % 8)
    return bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))


def png(rows, kind=GREY, depth=8, palette=None, interlaced=False):
    """A PNG of rows of samples; `kind` is the PNG colour type."""
    channels = CHANNELS[kind]
    width, height = len(rows[0]) // channels, len(rows)
    passes = [(0, 0, 1, 1)]
    if interlaced:
        passes = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4),
                  (1, 0, 2, 2), (0, 1, 1, 2)]
    raw = b""
    for left, top, step_x, step_y in passes:
        columns = range(left, width, step_x)
        for row in rows[top::step_y] if columns else []:
            part = [s for x in columns for s in row[x * channels:(x + 1) * channels]]
            raw += b"\0" + packed_row(part, depth)
    header = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, int(interlaced))
    extra = chunk(b"PLTE", bytes(palette)) if palette else b""
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra +
            chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


def paeth(a, b, c):
    estimate = a + b - c
    return min((abs(estimate - a), 0, a), (abs(estimate - b), 1, b), (abs(estimate - c), 2, c))[2]


def read_png(data):
    """Width, height and rows of an 8-bit RGB or grey PNG that is not interlaced."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    position, packed, header = 8, b"", None
    while position < len(data):
        length, kind = struct.unpack(">I4s", data[position:position + 8])
        body = data[position + 8:position + 8 + length]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        packed += body if kind == b"IDAT" else b""
        position += 12 + length
    width, height, depth, colour_type = header[:4]
    assert depth == 8 and header[6] == 0
    step = CHANNELS[colour_type]
    stride, raw = width * step, zlib.decompress(packed)
    rows, above = [], bytes(stride)
    for y in range(height):
        start = y * (stride + 1)
        method, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            left = row[i - step] if i >= step else 0
            corner = above[i - step] if i >= step else 0
            guess = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))
            row[i] = (row[i] + guess[method]) & 255
        rows.append(list(row))
        above = row
    return width, height, rows


def pgm(rows, maximum=255):
    """A binary PGM with a comment in its header."""
    head = f"P5\n# made by a test\n{len(rows[0])} {len(rows)}\n{maximum}\n".encode()
    size = ">H" if maximum > 255 else ">B"
    return head + b"".join(struct.pack(size, s) for row in rows for s in row)


def ppm(rows):
    head = f"P6 {len(rows[0]) // 3} {len(rows)} 255\n".encode()
    return head + b"".join(bytes(row) for row in rows)


def disc_share(x, y, cx, cy, radius):
    """How much of pixel (x, y) a disc covers, to first order."""
    return min(1.0, max(0.0, radius - math.hypot(x - cx, y - cy) + 0.5))


def ball(width, height, cx, cy, radius, colour=(230, 110, 30), ground=(60, 80, 90)):
    """Rows of R, G, B: an antialiased disc before a plain ground."""
    rows = []
    for y in range(height):
        row = []
        for x in range(width):
            share = disc_share(x, y, cx, cy, radius)
            row += [round(g + share * (c - g)) for c, g in zip(colour, ground)]
        rows.append(row)
    return rows


def channel(rows, index):
    """One channel of R, G, B rows."""
    return [row[index::3] for row in rows]
