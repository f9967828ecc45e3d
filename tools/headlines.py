#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The README's short table, taken from the long ones.

usage: tools/headlines.py [--check FILE | --update FILE]

Measures nothing: each figure is looked up where a command of its own has put it
and holds it (tests/FIGURES.md by tools/figures.sh, lib/COSTS.md by tools/sizes.sh,
tests/budgets.csv by the boards' tests).  Prints the table; --check compares it with
the block <!-- headlines:begin --> of FILE, --update writes it there.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

import budgets

ROOT = pathlib.Path(__file__).resolve().parents[1]
FIGURES, SIZES = ROOT / "tests" / "FIGURES.md", ROOT / "lib" / "COSTS.md"
PIXELS = 320 * 240


def find(path, pattern):
    """The groups of the one place in the file that matches."""
    found = re.findall(pattern, path.read_text(), re.MULTILINE)
    if len(found) != 1:
        sys.exit(f"headlines: {len(found)} places for '{pattern}' in {path.relative_to(ROOT)}, "
                 "one is wanted; mend the pattern in tools/headlines.py")
    return found[0]


def million(text):
    return f"{int(text) / 1e6:.2f} M"


def frame(name):
    """A row of the table of frames: ocellus, then OpenCV's two ways."""
    own, first, second = find(FIGURES, rf"^\| {name} \| (\d+) \|[^|]*\|[^|]*\| (\d+) \| (\d+) \|$")
    low, high = sorted([int(first), int(second)])
    return million(own), f"OpenCV {million(low)} to {million(high)}"


def board_frame(name):
    count = budgets.read()["m4", "ocel_eye_frame", name]
    return f"{million(count)}, {count / PIXELS:.1f} a pixel", ""


def any_frame():
    bound, seen = find(SIZES, r"^\| `ocel_eye_frame` \| (\d+) \| (\d+) \| [\d.]+ \|")
    return million(bound) + " at most", f"worst found {million(seen)}"


def fit():
    own, = [find(FIGURES, r"^\| `ocel_fit_cracks`, `b2ac` \| (\d+) \|")]
    other = find(FIGURES, r"^\| OpenCV `fitEllipseDirect` \| (\d+) \|")
    return f"{int(own) / 1e3:.1f} k", f"OpenCV {int(other) / 1e3:.0f} k"


def exact():
    worst = find(FIGURES, r"^claim: worst error .* arcs >= 90 deg, px: (\S+) <=")
    strict = max(map(float, re.findall(r"^\s*\d+-\s*\d+ +\d+ +\d+ +([\d.]+)% \|",
                                       FIGURES.read_text(), re.MULTILINE)))
    return f"{float(worst) * 1e6:.0f}e-6 px at worst", f"textbook 6x6: no ellipse in {strict:.0f} %"


def last_of_row(section, name):
    """RMS radius error in % of the last column, half of the ball hidden."""
    text = FIGURES.read_text().split(section, 1)[1]
    row = re.search(rf"^{name} +\|.*\| +([\d.]+) [^|]*$", text, re.MULTILINE)
    return float(row[1])


def hidden():
    section = "The ball anywhere in the image:\nhidden"
    return (f"{last_of_row(section, 'cone of rays'):.2f} %",
            f"paper's LCSE {last_of_row(section, 'lcse'):.0f} %")


def ranges():
    own = find(FIGURES, r"^cone of rays +\| +[\d.]+ \| +([\d.]+) \|")
    paper = find(FIGURES, r"^paper's chain +\| +[\d.]+ \| +([\d.]+) \|")
    return f"{float(own):.2f} mm", f"paper's chain {float(paper):.1f} mm"


def cone():
    own = find(FIGURES, r"^The robust cone fit, .*: (\d+) instructions")
    return f"{int(own) / 1e3:.1f} k", ""


def code():
    return find(SIZES, r"^\| the eye, on RGB565 lines by a const table .*?\| (\d+) \|") + " bytes", ""


def memory():
    context = find(SIZES, r"^\| `ocel_eye_t` without its boundary pool \| (\d+) \|")
    pool = find(SIZES, r"^\| its boundary pool, `ocel_crack_pool_t` \| (\d+) \|")
    return f"{int(context) + int(pool)} bytes", ""


def stack():
    rows = re.findall(r"^\| `ocel_\w+` \| (\d+) \|$", SIZES.read_text().split("Stack, bytes")[1],
                      re.MULTILINE)
    return f"{max(map(int, rows))} bytes", ""


ROWS = (
    ("320x240 frame with a ball, colour to ellipse; instructions, x86-64", lambda: frame("plain")),
    ("the same with 5 % salt noise", lambda: frame("salt")),
    ("the same, RGB565, on a Cortex-M4", lambda: board_frame("plain")),
    ("the same with 5 % salt noise, on a Cortex-M4", lambda: board_frame("salt")),
    ("any 320x240 frame of any format, proved from the machine code, on a Cortex-M4", any_frame),
    ("ellipse fit of 250 boundary points; instructions, x86-64", fit),
    ("ellipse through exact points, arcs from 90 degrees", exact),
    ("radius of a ball half hidden by an edge, R = 40 px, RMS error", hidden),
    ("range of a whole ball at 500 mm, RMS error", ranges),
    ("the robust cone fit of 340 boundary points; instructions, x86-64", cone),
    ("memory: the eye's context, 320 px wide", memory),
    ("stack, any function, Cortex-M4", stack),
    ("code of the eye alone, Cortex-M4 -O2", code),
)


def table():
    lines = ["| what | ocellus | beside it |", "|---|--:|---|"]
    for what, figures in ROWS:
        own, other = figures()
        lines.append(f"| {what} | {own} | {other} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    mode = parser.add_mutually_exclusive_group()
    mode.add_argument("--check", metavar="FILE")
    mode.add_argument("--update", metavar="FILE")
    args = parser.parse_args()
    text = table()
    print(text, end="")
    file = args.check or args.update
    if not file:
        return 0
    with tempfile.NamedTemporaryFile("w", suffix=".md") as made:
        made.write(text)
        made.flush()
        return subprocess.run(
            [sys.executable, ROOT / "tools" / "readme_block.py", "--check" if args.check else "--update",
             "--fix", f"Run tools/headlines.py --update {file}", file, "headlines", made.name],
            check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
