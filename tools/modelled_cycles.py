#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Modelled cycles of each call that call_cost makes, on Cortex-M0+, M3 or M4.

Runs the program tests/board/call_cost of a board's build under QEMU with a plugin
that follows every instruction, and applies the published timings of the core
(tools/wcet/timing.py): zero wait states, no interrupt, `typ` and `max` where the
manual gives a range.  No figure here was compared with a chip.

The instructions are those between two readings of the counter, less those of an
empty call, as call_cost itself counts them.
"""
import argparse
import csv
import sys

from wcet import observe, timing
from wcet.boards import QEMU, of_core
from wcet.code import Refused

COLUMNS = ["function", "input", "core", "insn", "cycles_typ", "cycles_max"]


def between(marks):
    """What was executed from each reading of the counter to the next."""
    return [observe.Counts(*(b - a for a, b in zip(first, second)))
            for first, second in zip(marks[::2], marks[1::2])]


def rows_of(observed, core):
    """One row for each line that call_cost wrote; its first call is the empty one,
    which is measured twice."""
    said = [line.split(",") for line in observed.text.splitlines()]
    spans = between(observed.marks)
    if not said or said[0][0] != "unit" or len(spans) != len(said) + 1:
        raise Refused(f"{len(said)} lines and {len(spans)} readings: is this call_cost?")
    empty = spans[1]
    rows = []
    for (function, given, _, _), span in zip(said[1:], spans[2:]):
        rows.append([function, given, core, *(max(0, a - b) for a, b in zip(span, empty))])
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="build/m4/bin/call_cost, or that of m3 or m0")
    parser.add_argument("--core", choices=sorted(timing.OF_COMPILER), required=True,
                        help="the core that it was built for")
    parser.add_argument("--csv", metavar="FILE", help="where to write the table (default: stdout)")
    args = parser.parse_args()
    core = timing.OF_COMPILER[args.core]
    try:
        observed = observe.observe(args.program, core, [*QEMU, "-M", of_core(args.core).machine,
                                                        "-icount", "shift=7,sleep=off"],
                                   mark="ocel_port_ticks")
        rows = rows_of(observed, core)
    except (Refused, OSError, KeyError) as error:
        print(f"modelled_cycles: {args.program}: {error}", file=sys.stderr)
        return 1
    with open(args.csv, "w", encoding="utf-8", newline="") if args.csv else sys.stdout as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(COLUMNS)
        out.writerows(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
