#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each stage costs: instructions a call, and a unit of its input.

Runs tests/bench/stage_cost under callgrind (when valgrind is there; without
it, only the machine's clock is read) and writes cycles.md and calls_host.csv into
--out.  Instructions are exact and repeatable; nanoseconds are this machine's
and are reported, never asserted.  A stage that takes more instructions than its
budget (tools/budgets.py) fails.
"""
import argparse
import csv
import pathlib
import shutil
import subprocess
import sys

import budgets
from callgrind_costs import measure


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="build/host/bin/stage_cost")
    parser.add_argument("--out", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("--budgets", type=pathlib.Path, default=budgets.FILE, metavar="CSV")
    args = parser.parse_args()

    run = subprocess.run([args.program, "20"], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        print(run.stdout + run.stderr, file=sys.stderr)
        return 1
    stages = [line.split(";") for line in run.stdout.splitlines()]
    costs = {}
    if shutil.which("valgrind"):
        costs, _ = measure([args.program], "^measure_")
    limits = budgets.limits("host", args.budgets)
    rows = [(name, text, int(units), costs.get(f"measure_{name}", (None,))[0],
             limits.get((name, text)), int(ns)) for name, text, units, ns in stages]

    args.out.mkdir(parents=True, exist_ok=True)
    with (args.out / "calls_host.csv").open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["function", "input", "units", "insn", "budget", "ns"])
        writer.writerows(rows)
    lines = ["Cost of each stage on this machine (instructions by callgrind; ns by the clock, "
             "fastest of 20).", "",
             "| stage | input | units | instructions | a unit | budget | ns |",
             "|---|---|--:|--:|--:|--:|--:|"]
    for name, text, units, insn, budget, ns in rows:
        each = "" if insn is None else f"{insn / units:.2f}"
        lines.append(f"| {name} | {text} | {units} | {'' if insn is None else insn} | {each} "
                     f"| {'' if budget is None else budget} | {ns} |")
    if not costs:
        lines += ["", "No valgrind here: instructions were not counted."]
    (args.out / "cycles.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    within = budgets.report("host", {row[:2]: row[3] for row in rows}, args.budgets)
    return 0 if within else 1


if __name__ == "__main__":
    sys.exit(main())
