#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Worst-case execution time of every public function, from the machine code.

Builds the library for a core, a size and an optimisation, reads its control flow from
the ELF, takes the bounds of its loops from the comments beside them, and finds the
longest path by linear programming.  The figures are instructions, exactly as QEMU counts
them, and modelled cycles: published timings (tools/wcet/timing.py), `typ` and `max` where
the manual gives a range, zero wait states, no interrupt.  No input takes longer.

What it cannot bound it refuses, by function, address and source line: a recursion, a
jump or call to a computed place, a loop without a bound.  port/README.md tells more.

examples:
  tools/wcet.py --core m4 --width 320 --height 240 -O2      the bounds on your core
  tools/wcet.py --core m0 -Os --observe                     beside what was observed
  tools/wcet.py --core m4 -O2 --explain ocel_eye_end        where a bound comes from
  tools/wcet.py --update lib/COSTS.md                       that file's table (--check)
"""
import argparse
import csv
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True

from wcet import report  # noqa: E402
from wcet.boards import ROOT  # noqa: E402
from wcet.build import Config  # noqa: E402
from wcet.code import Refused  # noqa: E402
from wcet.study import Study  # noqa: E402


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--core", choices=["m0", "m3", "m4"], default="m4",
                        help="what the compiler makes code for (default m4)")
    parser.add_argument("-O", dest="levels", action="append", metavar="LEVEL",
                        help="s, 2, 3 ...: may be given more than once (default 2)")
    parser.add_argument("--width", type=int, default=320, help="OCEL_MAX_WIDTH (default 320)")
    parser.add_argument("--height", type=int, default=240, help="OCEL_MAX_HEIGHT (default 240)")
    parser.add_argument("--cracks", type=int, default=2048, help="OCEL_MAX_CRACKS (default 2048)")
    parser.add_argument("--observe", action="store_true",
                        help="run the corpus and the adversarial inputs under QEMU too, and fail "
                        "when one took longer than its bound, or a bound is looser than --limits")
    parser.add_argument("--limits", metavar="CSV", default=ROOT / "tests" / "wcet" / "limits.csv",
                        help="how loose a bound may be (default tests/wcet/limits.csv)")
    parser.add_argument("--explain", metavar="FUNCTION", help="where its worst path spends its instructions")
    parser.add_argument("--check", metavar="FILE", help="compare the block <!-- wcet:begin --> of "
                        "FILE with the bounds: each number within 2 %%")
    parser.add_argument("--update", metavar="FILE", help="write them there")
    parser.add_argument("--csv", metavar="FILE", help="write the table as CSV too")
    parser.add_argument("--markdown", metavar="FILE", help="write the table there too")
    parser.add_argument("--build", metavar="FOLDER", default=ROOT / "build" / "host" / "wcet",
                        help="where it builds (default build/host/wcet, as the tests do)")
    return parser.parse_args()


def explain(study, name):
    analysis = study.analysis(study.library())
    print(f"{name}: at most {analysis.bound(name)[0]} instructions; of its worst path")
    print("  instructions  executions  function, source line, call")
    for cost, times, function, where, callee in analysis.explain(name):
        if times > 0:
            print(f"{cost:14.0f} {times:11.1f}  {function} {where} {callee}")


def readme_table(args):
    """Compares or writes the table of lib/COSTS.md; returns the exit status."""
    large, small = (320, 240), (160, 120)
    configs = (("m4", *large, 2048), ("m4", *small, 1024), ("m0", *large, 2048))
    rows = []
    for i, (core, width, height, cracks) in enumerate(configs):
        study = Study(Config(core, "-O2", width, height, cracks), args.build)
        rows.append(study.rows(observing=i == 0))
        refused = [row.refused for row in rows[-1] if row.refused]
        if refused:
            raise Refused("\n".join(refused))
    path = pathlib.Path(args.build) / "readme.md"
    path.write_text(report.readme((large, small), rows), encoding="utf-8")
    mode, file = ("--check", args.check) if args.check else ("--update", args.update)
    return subprocess.run([ROOT / "tools" / "readme_block.py", mode, "--tolerance", "2", "--fix",
                           f"Run tools/wcet.py --update {file}", file, "wcet", path],
                          check=False).returncode


def main():
    args = arguments()
    failed = []
    tables = []
    try:
        if args.check or args.update:
            return readme_table(args)
        for level in args.levels or ["2"]:
            config = Config(args.core, f"-O{level}", args.width, args.height, args.cracks)
            study = Study(config, args.build)
            if args.explain:
                explain(study, args.explain)
                continue
            rows = study.rows(observing=args.observe)
            limits = report.read_limits(args.limits) if args.observe else {}
            tables.append((config, rows, limits))
            failed += report.faults(config, rows, limits)
    except (Refused, OSError) as error:
        print(f"wcet: {error}", file=sys.stderr)
        return 1
    text = "\n".join(report.table(*table) for table in tables)
    print(text)
    if args.markdown:
        with open(args.markdown, "w", encoding="utf-8") as file:
            file.write(text)
    if args.csv:
        with open(args.csv, "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(report.csv_rows(tables))
    for fault in failed:
        print(f"wcet: {fault}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
