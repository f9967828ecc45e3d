#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares or replaces a measured block of a Markdown file.

The block stands between the lines <!-- NAME:begin --> and <!-- NAME:end -->.
--check compares it with MEASURED: the text must be the same, and each number
within --tolerance percent of the stated one (0: the very same).  In a table
column whose heading contains the word of --loose, --loose-tolerance holds
instead: for what a library of the machine costs, which differs with its
processor.  --update writes MEASURED into the block.
"""
import argparse
import pathlib
import re
import sys

NUMBER = re.compile(r"(?<![\w.])[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w])")


def find_block(text, name):
    begin, end = f"<!-- {name}:begin -->\n", f"<!-- {name}:end -->"
    start = text.find(begin)
    stop = text.find(end)
    if start < 0 or stop < start:
        return None
    return start + len(begin), stop


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def compare_cell(stated, measured, tolerance):
    """True when the texts agree, but for the width of blanks, and each number is
    within tolerance percent."""
    stated, measured = " ".join(stated.split()), " ".join(measured.split())
    if stated == measured:
        return True
    if NUMBER.sub("#", stated) != NUMBER.sub("#", measured):
        return False
    pairs = zip(NUMBER.findall(stated), NUMBER.findall(measured))
    for old, new in ((float(a.replace("−", "-")), float(b.replace("−", "-"))) for a, b in pairs):
        if abs(new - old) > tolerance / 100.0 * max(abs(old), abs(new)):
            return False
    return True


def compare(stated, measured, args):
    """The differences between two lists of lines, as (stated, measured) pairs."""
    if len(stated) != len(measured):
        return [(f"{len(stated)} lines", f"{len(measured)} lines")]
    different, heading = [], []
    for old, new in zip(stated, measured):
        if not new.startswith("|"):
            heading = []
            if not compare_cell(old, new, args.tolerance):
                different.append((old, new))
            continue
        old_cells, new_cells = cells(old), cells(new)
        if not heading:
            heading = new_cells
        same = len(old_cells) == len(new_cells)
        for index, (a, b) in enumerate(zip(old_cells, new_cells)):
            title = heading[index] if index < len(heading) else ""
            loose = args.loose and args.loose in title
            same &= compare_cell(a, b, args.loose_tolerance if loose else args.tolerance)
        if not same:
            different.append((old, new))
    return different


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    mode = parser.add_mutually_exclusive_group(required=True)
    mode.add_argument("--check", action="store_true")
    mode.add_argument("--update", action="store_true")
    parser.add_argument("--tolerance", type=float, default=0.0, metavar="PERCENT")
    parser.add_argument("--loose", default="", metavar="WORD")
    parser.add_argument("--loose-tolerance", type=float, default=50.0, metavar="PERCENT")
    parser.add_argument("--fix", default="", help="what to say when the block differs")
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("name")
    parser.add_argument("measured", type=pathlib.Path)
    args = parser.parse_args()

    if not args.file.is_file():
        print(f"{args.file}: no such file", file=sys.stderr)
        return 1
    text = args.file.read_text()
    place = find_block(text, args.name)
    if place is None:
        print(f"{args.file}: no block <!-- {args.name}:begin --> ... <!-- {args.name}:end -->",
              file=sys.stderr)
        return 1
    measured = args.measured.read_text().strip("\n") + "\n"
    stated = text[place[0]:place[1]]
    if args.update:
        if stated != measured:
            args.file.write_text(text[:place[0]] + measured + text[place[1]:])
        return 0
    different = compare(stated.strip("\n").splitlines(), measured.splitlines(), args)
    for old, new in different:
        print(f"{args.file}: stated   {old}\n{args.file}: measured {new}", file=sys.stderr)
    if different:
        print(f"{args.file}: the block '{args.name}' is not what was measured. {args.fix}",
              file=sys.stderr)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
