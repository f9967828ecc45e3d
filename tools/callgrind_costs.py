#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Instructions a call of each named function of a program, by callgrind.

Runs PROGRAM ARGS... under valgrind --tool=callgrind and prints, for each
function whose name matches --functions (a regular expression), the line
`name instructions calls`: instructions include everything that it called, and
are the average over its calls.  The counts are the same in every run.
"""
import argparse
import collections
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

NAME = re.compile(r"\((\d+)\)(?: (.*))?")


def read_callgrind(text):
    """function -> [inclusive instructions, calls], from a callgrind.out file.

    The format: `fn=(1) name` begins a function, of which `cfn=` and `calls=`
    lines describe calls; the line after `calls=` carries the callee's inclusive
    cost, every other line of numbers an own cost.  Names are given once and
    repeated by their number."""
    names, cost = {}, collections.defaultdict(lambda: [0, 0])
    current = callee = None

    def name_of(value):
        number, name = NAME.fullmatch(value).groups()
        if name:
            names[number] = re.sub(r"'\d+$", "", name)  # callgrind's mark of a recursion
        return names[number]

    for line in text.splitlines():
        if line.startswith("fn="):
            current = name_of(line[3:])
        elif line.startswith("cfn="):
            callee = name_of(line[4:])
        elif line.startswith("calls="):
            cost[callee][1] += int(line[6:].split()[0])
        elif line and (line[0].isdigit() or line[0] in "+-*") and current:
            cost[current][0] += int(line.split()[1])  # position, instructions
    return cost


def measure(command, pattern):
    if shutil.which("valgrind") is None:
        sys.exit("callgrind_costs: no valgrind here; run tools/setup.sh test")
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "callgrind.out"
        run = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", *command],
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        if run.returncode != 0:
            sys.exit(f"callgrind_costs: {' '.join(command)} failed:\n{run.stdout}{run.stderr}")
        costs = read_callgrind(out.read_text())
    wanted = re.compile(pattern)
    return {name: (total // calls, calls) for name, (total, calls) in costs.items()
            if calls and wanted.search(name)}, run.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--functions", default="^measure_", metavar="REGEX")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    args = parser.parse_args()
    if not args.command:
        parser.error("name the program to run")
    costs, _ = measure(args.command, args.functions)
    for name, (instructions, calls) in sorted(costs.items()):
        print(name, instructions, calls)
    return 0


if __name__ == "__main__":
    sys.exit(main())
