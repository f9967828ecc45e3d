#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs call_cost on its board and writes what it says as CSV and as a table.

usage: report.py NAME FOLDER COMMAND...

Writes FOLDER/calls_NAME.csv and FOLDER/calls_NAME.md, prints the table, and gives
every figure to CTest as a measurement.
"""
import csv
import subprocess
import sys


def table(name, unit, rows):
    lines = [f"{unit} a call, {name}:", "",
             "| function | input | units | a call | a unit |", "|---|---|--:|--:|--:|"]
    for function, given, units, count in rows:
        each = f"{count / units:.2f}" if units > 1 else ""
        lines.append(f"| {function} | {given} | {units} | {count} | {each} |")
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    name, folder, command = sys.argv[1], sys.argv[2], sys.argv[3:]
    run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                         check=False)
    lines = [line.split(",") for line in run.stdout.splitlines()]
    if run.returncode != 0 or not lines or lines[0][0] != "unit":
        sys.exit(f"report: exit code {run.returncode}\n{run.stdout}{run.stderr}")
    unit = lines[0][1]
    rows = [(function, given, int(units), int(count)) for function, given, units, count in lines[1:]]
    with open(f"{folder}/calls_{name}.csv", "w", encoding="utf-8", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["function", "input", "units", unit])
        out.writerows(rows)
    text = table(name, unit, rows)
    with open(f"{folder}/calls_{name}.md", "w", encoding="utf-8") as file:
        file.write(text)
    print(text)
    for function, given, _, count in rows:
        label = f"{function} {given}".strip()
        print(f'<CTestMeasurement type="numeric/double" name="{label}">{count}</CTestMeasurement>')
    return 0


if __name__ == "__main__":
    sys.exit(main())
