#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Records a scenario with the simulator, replays it on a board, compares bit by bit.

The recording is made anew each time, so that it is of the simulator and the library as
they are now.  Fails when one member of one answer differs from the host's, or when a
frame takes more instructions than the bounds that tools/wcet.py states for --core, or
than tests/budgets.csv allows.
"""
import argparse
import csv
import os
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import budgets  # noqa: E402

# What was done, and its columns of a `frame` line after the name: left, right, both.
STAGES = (("frame to ellipse", (0, 2)), ("frame to sphere", (1, 3)), ("poses and ball", (4,)))


def record(args):
    if not os.access(args.sim, os.X_OK):
        sys.exit(f"replay: no simulator at {args.sim}, which records what is replayed: build it\n"
                 "with cmake --preset host && cmake --build --preset host, or configure this\n"
                 "build with -DOCEL_SIM=<path of an ocellus-sim>")
    args.recording.mkdir(parents=True, exist_ok=True)
    for stale in args.recording.glob("answers*.csv"):
        stale.unlink()
    run = subprocess.run([args.sim, "run", args.scenario, "--out", args.recording / "run",
                          "--record", args.recording], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"replay: the simulator cannot record {args.scenario}:\n{run.stdout}{run.stderr}")


def replay(args):
    """The program's text, line by line and split at the commas."""
    run = subprocess.run(args.command, cwd=args.recording, stdin=subprocess.DEVNULL,
                         capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"replay: exit code {run.returncode}\n{run.stdout[-2000:]}{run.stderr}")
    return [line.split(",") for line in run.stdout.splitlines()]


def rows_of(path):
    with path.open(newline="") as file:
        return list(csv.reader(file))


def differences(recording):
    """What is not the host's, as text; and how many rows and members were compared."""
    host, board = rows_of(recording / "answers.csv"), rows_of(recording / "answers_replay.csv")
    found = []
    if host[0] != board[0]:
        found.append("the members are not the same: build simulator and firmware of one commit")
    if len(host) != len(board):
        found.append(f"the host answered to {len(host) - 1} pairs, the board to {len(board) - 1}")
    for ours, theirs in zip(host[1:], board[1:]):
        found += [f"point {ours[0]} trial {ours[1]} frame {ours[2]}: {name} is {b}, the host's is {a}"
                  for name, a, b in zip(host[0], ours, theirs) if a != b]
    return found, len(host) - 1, len(host[0]) - 3


def bounds_table(args, size):
    """Where the bounds are: in what the test wcet_CORE of the host's build reported, when
    that is of this library and of 320x240; else tools/wcet.py is run for them."""
    reported = args.sim.resolve().parents[1] / "reports" / f"wcet_{args.core}.csv"
    newest = max(path.stat().st_mtime for path in (ROOT / "lib").glob("**/*.[ch]"))
    if size == ("320", "240") and reported.exists() and reported.stat().st_mtime > newest:
        return reported
    table = args.recording / "bounds.csv"
    run = subprocess.run([ROOT / "tools" / "wcet.py", "--core", args.core, "--width", size[0],
                          "--height", size[1], "--csv", table, "--build",
                          args.recording / "wcet"], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"replay: tools/wcet.py states no bounds:\n{run.stdout[-2000:]}{run.stderr}")
    return table


def bounds_of(args):
    """stage -> instructions at most, for frames of the recording's size."""
    if not args.core:
        return {}
    told = dict(line.split(" ", 1)
                for line in (args.recording / "manifest.txt").read_text().splitlines())
    with bounds_table(args, (told["width"], told["height"])).open(newline="") as file:
        of = {row["function"]: int(row["bound_insn"] or 0) for row in csv.DictReader(file)
              if row["level"] == "-O2"}
    ellipse = (of["ocel_eye_begin"] + int(told["height"]) * of["ocel_eye_line"] +
               of["ocel_eye_end"])
    return {"frame to ellipse": ellipse,
            "frame to sphere": ellipse + of["ocel_eye_cone"] + of["ocel_sphere_of_cone"],
            "poses and ball": of["ocel_head_forward"] + of["ocel_stereo_ball"]}


def judge(frames, bounds):
    """(stage, median, most, bound or None) of each stage, of all frames."""
    rows = []
    for stage, columns in STAGES:
        counts = [frame[column] for frame in frames for column in columns]
        rows.append((stage, int(statistics.median(counts)), max(counts), bounds.get(stage)))
    return rows


def within_budget(args, rows):
    """Writes what the frames took where tools/budgets.py looks for it, and asks it."""
    target = f"{args.name}-replay"
    taken = {(stage, what): count for stage, median, most, _ in rows
             for what, count in (("median", median), ("max", most))}
    with (args.reports / f"calls_{target}.csv").open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(("function", "input", "insn"))
        out.writerows((*key, count) for key, count in taken.items())
    return budgets.report(target, taken)


def write_report(args, headline, unit, rows):
    lines = [headline, "", f"| {unit} a frame | median | max | bound |", "|---|--:|--:|--:|"]
    lines += [f"| {stage} | {median} | {most} | {bound or ''} |" for stage, median, most, bound in rows]
    text = "\n".join(lines) + "\n"
    (args.reports / f"replay_{args.name}.md").write_text(text)
    print(text)
    for stage, *values in rows:
        for what, value in zip(("median", "max", "bound"), values):
            if value is not None:
                print(f'<CTestMeasurement type="numeric/double" name="{stage}, {what}">{value}'
                      "</CTestMeasurement>")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--name", required=True, help="the board's, for the report")
    parser.add_argument("--sim", type=pathlib.Path, required=True, help="the program ocellus-sim")
    parser.add_argument("--scenario", type=pathlib.Path, required=True)
    parser.add_argument("--recording", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("--reports", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("--core", help="of tools/wcet.py, for the bounds")
    parser.add_argument("command", nargs="+", help="the replaying program, and what runs it")
    args = parser.parse_args()

    record(args)
    said = replay(args)
    frames = [[int(count) for count in line[1:]] for line in said if line[0] == "frame"]
    if not frames:
        sys.exit("replay: the recording has no frame")
    wrong, pairs, members = differences(args.recording)
    rows = judge(frames, bounds_of(args))
    write_report(args, f"Replay of {args.scenario.name} on {args.name}: {pairs} pairs, {2 * pairs} "
                 f"frames; of {members} members of each pair's answers {len(wrong) or 'none'} "
                 "not the host's.", said[0][1], rows)
    wrong += [f"{stage} took {most} instructions, over the bound of {bound}"
              for stage, _, most, bound in rows if bound is not None and most > bound]
    for line in wrong[:20]:
        print(f"replay: {line}", file=sys.stderr)
    return 0 if within_budget(args, rows) and not wrong else 1


if __name__ == "__main__":
    sys.exit(main())
