#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each public function and stage takes on a board: instructions, modelled cycles, stack.

Runs the programs call_cost (counted instructions) and call_stack (a painted stack),
puts beside them the budgets of tests/budgets.csv, the modelled cycles of
tools/modelled_cycles.py where --core names a core it knows, and the static worst case
of the stack (tools/stack.py, from what the compiler said of --objects).  Writes
calls_NAME.csv and calls_NAME.md to --reports, prints the tables and gives every
figure to CTest as a measurement.

Fails when a call takes more than its budget, when a public function is not measured,
or when one used more stack than its static worst case; and when the pipeline's static
worst case is over --stack-limit.
"""
import argparse
import csv
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import budgets  # noqa: E402
import stack  # noqa: E402

PIPELINE = "frame to sphere"
COLUMNS = ("function", "input", "units", "insn", "budget", "cycles_typ", "cycles_max",
           "stack_painted", "stack_static")


class Call:
    """One line of the report."""

    def __init__(self, function, given, units, insn):
        self.function, self.given = function, given
        self.units, self.insn = int(units), int(insn)
        self.budget = self.cycles_typ = self.cycles_max = self.painted = self.static = ""

    @property
    def key(self):
        return self.function, self.given

    def cells(self):
        return (self.function, self.given, self.units, self.insn, self.budget, self.cycles_typ,
                self.cycles_max, self.painted, self.static)


def run(args, program, unit):
    """The lines that a program said, split at the commas, without the first."""
    ran = subprocess.run([*args.emulator, program], stdin=subprocess.DEVNULL,
                         capture_output=True, text=True, check=False)
    lines = [line.split(",") for line in ran.stdout.splitlines()]
    if ran.returncode != 0 or not lines or lines[0] != ["unit", unit]:
        sys.exit(f"report: {program} ended with {ran.returncode}:\n{ran.stdout}{ran.stderr}")
    return lines[1:]


def add_stack(args, calls):
    """What each call painted, without the frame of who makes it, beside its static worst
    case: a function's own, a stage's as its caller's without the frame."""
    graph = stack.Graph(stack.ci_files(args.objects))
    public = stack.public_functions(args.include)
    for call, (*key, _, size, caller) in zip(calls, run(args, args.stack, "bytes")):
        if list(call.key) != key:
            sys.exit(f"report: call_stack measures {key} where call_cost measures {call.key}")
        frame = graph.frame(caller)
        call.painted = max(0, int(size) - frame)
        call.static = graph.depth(call.function if call.function in public
                                  else caller)[0] - (0 if call.function in public else frame)
    return public


def add_cycles(args, calls):
    if not args.core:
        return
    ran = subprocess.run([ROOT / "tools" / "modelled_cycles.py", args.cost, "--core", args.core],
                         capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        sys.exit(f"report: modelled_cycles.py ended with {ran.returncode}:\n{ran.stderr}")
    of_call = {(row["function"], row["input"]): row for row in csv.DictReader(ran.stdout.splitlines())}
    for call in calls:
        row = of_call[call.key]
        call.cycles_typ, call.cycles_max = int(row["cycles_typ"]), int(row["cycles_max"])


def markdown(titles, rows, left=2):
    lines = ["| " + " | ".join(titles) + " |",
             "|" + "---|" * left + "--:|" * (len(titles) - left)]
    return lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]


def cost_table(args, calls):
    cycles = "" if not args.core else (
        " Cycles are modelled (zero wait states, no interrupt; typical and upper timings), "
        "not a chip's.")
    rows = [(*call.cells()[:4], f"{call.insn / call.units:.2f}" if call.units > 1 else "",
             *call.cells()[4:8]) for call in calls]
    return [f"Each call on {args.name}: instructions, exact; stack, bytes, painted.{cycles}", "",
            *markdown(("function", "input", "units", "insn", "a unit", "budget", "cycles typ",
                       "cycles max", "stack"), rows)]


def stack_rows(calls):
    """name -> (static, most painted), of functions and of the pipeline."""
    rows = {}
    for call in calls:
        if call.function.startswith("ocel_") or call.function == PIPELINE:
            static, painted = rows.get(call.function, (0, 0))
            rows[call.function] = (max(static, call.static), max(painted, call.painted))
    return rows


def stack_table(name, rows):
    table = [(function, static, painted, f"{static / painted:.2f}" if painted else "")
             for function, (static, painted) in rows.items()]
    return ["", f"Stack on {name}, bytes: static worst case beside the most that was painted:", "",
            *markdown(("function", "static", "painted", "ratio"), table, left=1)]


def judge(args, calls, rows, public):
    wrong = [f"{name} is public and not measured (tests/board/calls_*.c)"
             for name in public if name not in rows]
    wrong += [f"{name} used {painted} bytes of stack, over its static worst case of {static}"
              for name, (static, painted) in rows.items() if painted > static]
    if args.stack_limit and rows[PIPELINE][0] > args.stack_limit:
        wrong.append(f"{PIPELINE}: {rows[PIPELINE][0]} bytes of stack, over {args.stack_limit}")
    for line in wrong:
        print(f"report: {args.name}: {line}", file=sys.stderr)
    within = budgets.report(args.name, {call.key: call.insn for call in calls})
    return within and not wrong


def write_reports(args, calls, text):
    with (args.reports / f"calls_{args.name}.csv").open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(COLUMNS)
        out.writerows(call.cells() for call in calls)
    (args.reports / f"calls_{args.name}.md").write_text(text)
    print(text)
    for call in calls:
        label = " ".join(call.key).strip()
        for what, value in zip(COLUMNS[3:], call.cells()[3:]):
            if value != "":
                print(f'<CTestMeasurement type="numeric/double" name="{label}, {what}">{value}'
                      "</CTestMeasurement>")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--name", required=True, help="the target in tests/budgets.csv")
    parser.add_argument("--cost", required=True, metavar="PROGRAM")
    parser.add_argument("--stack", required=True, metavar="PROGRAM")
    parser.add_argument("--objects", type=pathlib.Path, nargs="+", required=True,
                        help="object files beside which GCC left its .ci files")
    parser.add_argument("--include", type=pathlib.Path, default=ROOT / "lib" / "include")
    parser.add_argument("--core", help="of tools/modelled_cycles.py")
    parser.add_argument("--stack-limit", type=int, default=0, metavar="BYTES")
    parser.add_argument("--reports", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("emulator", nargs="+", help="what runs a program")
    args = parser.parse_args()

    calls = [Call(*line) for line in run(args, args.cost, "insn")]
    public = add_stack(args, calls)
    add_cycles(args, calls)
    limits = budgets.limits(args.name)
    for call in calls:
        call.budget = limits.get(call.key, "")
    rows = stack_rows(calls)
    write_reports(args, calls, "\n".join(cost_table(args, calls) + stack_table(args.name, rows)) + "\n")
    return 0 if judge(args, calls, rows, public) else 1


if __name__ == "__main__":
    sys.exit(main())
