#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each call may take, on the host and on each board: tests/budgets.csv.

usage: tools/budgets.py --update [--build FOLDER] TARGET...

A target is a preset (host, m0, m4 ...), or the firmware's replay on one (m4-replay).
The file holds the instructions that were measured when they were recorded last; counts
repeat exactly with one compiler, so a call that takes more than a margin over them fails
its test (host: stage_cycles, boards: call_cost, replay), and one that takes less by more
than the margin asks to be recorded.  --update takes over what the target's last test
reported in FOLDER/<preset>/reports; the commit message then says why.
"""
import argparse
import csv
import pathlib
import sys

FILE = pathlib.Path(__file__).resolve().parents[1] / "tests" / "budgets.csv"
COLUMNS = ("target", "function", "input", "instructions")
COMMENT = "# Instructions of each call when last recorded; tools/budgets.py tells the rule.\n"

# The host's counts vary a little with the processor, by which the C library picks its
# memset; a replay's with what renders its frames.
MARGIN_PERCENT = {"host": 10, "replay": 10}
BOARD_MARGIN_PERCENT = 2
LEAST_MARGIN = 8  # instructions: an alignment's, say, in a call that takes a hundred


def margin(target, recorded):
    percent = MARGIN_PERCENT.get(target.rpartition("-")[2], BOARD_MARGIN_PERCENT)
    return max(LEAST_MARGIN, recorded * percent // 100)


def read(path=FILE):
    """(target, function, input) -> instructions."""
    if not path.exists():
        return {}
    with path.open(newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return {(row["target"], row["function"], row["input"]): int(row["instructions"])
                for row in rows}


def write(budgets, path=FILE):
    with path.open("w", newline="") as file:
        file.write(COMMENT)
        out = csv.writer(file, lineterminator="\n")
        out.writerow(COLUMNS)
        out.writerows((*key, count) for key, count in budgets.items())


def limits(target, path=FILE):
    """(function, input) -> the most that it may take."""
    return {key[1:]: count + margin(target, count)
            for key, count in read(path).items() if key[0] == target}


def judge(target, measured, path=FILE):
    """What is wrong, as text, and what asks to be recorded; `measured` is
    (function, input) -> instructions, None where they could not be counted."""
    recorded = {key[1:]: count for key, count in read(path).items() if key[0] == target}
    wrong, asks = [], []
    for key, count in measured.items():
        name = " ".join(key).strip()
        if key not in recorded:
            wrong.append(f"{name} has no budget")
        elif count is None:
            continue
        elif count > recorded[key] + margin(target, recorded[key]):
            wrong.append(f"{name} takes {count} instructions, over its budget: "
                         f"recorded are {recorded[key]}")
        elif count < recorded[key] - margin(target, recorded[key]):
            asks.append(f"{name} takes {count} instructions, recorded are {recorded[key]}")
    wrong += [f"{' '.join(key).strip()} has a budget and is not measured"
              for key in recorded if key not in measured]
    return wrong, asks


def report(target, measured, path=FILE):
    """Prints what judge() finds; False when something is wrong."""
    wrong, asks = judge(target, measured, path)
    for line in wrong:
        print(f"budgets: {target}: {line}", file=sys.stderr)
    for line in asks:
        print(f"budgets: {target}: {line}: less, good")
    if wrong or asks:
        print(f"budgets: to record what is measured now: tools/budgets.py --update {target}")
    return not wrong


def reported(build, target):
    """What the target's last test measured."""
    preset = target.partition("-")[0]
    path = build / preset / "reports" / f"calls_{target}.csv"
    if not path.exists():
        sys.exit(f"budgets: no {path}; run ctest --preset {preset} first")
    with path.open(newline="") as file:
        return {(target, row["function"], row["input"]): int(row["insn"])
                for row in csv.DictReader(file) if row["insn"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", nargs="+", required=True, metavar="TARGET")
    parser.add_argument("--build", type=pathlib.Path, default=FILE.parents[1] / "build")
    args = parser.parse_args()
    budgets = read()
    for target in args.update:
        now = reported(args.build, target)
        budgets = {key: count for key, count in budgets.items() if key[0] != target} | now
        print(f"budgets: {len(now)} calls recorded for {target}")
    write(budgets)
    return 0


if __name__ == "__main__":
    sys.exit(main())
