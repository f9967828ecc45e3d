#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Records a scenario with the simulator, replays it on a board, compares bit by bit.

The recording is made anew each time, so that it is of the simulator and the library as
they are now.  Fails when one member of one answer differs from the host's, or when a
frame takes more instructions than --bounds states.
"""
import argparse
import csv
import os
import pathlib
import statistics
import subprocess
import sys

# The columns of a `frame` line after its name: what was done, for which eye.
ELLIPSE, SPHERE, BALL = (0, 2), (1, 3), (4,)


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


def read_bounds(path, name):
    """stage -> instructions at most, of this board."""
    if path is None:
        return {}
    return {stage: int(limit) for board, stage, limit in rows_of(path)[1:] if board == name}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--name", required=True, help="the board's, for the report")
    parser.add_argument("--sim", type=pathlib.Path, required=True, help="the program ocellus-sim")
    parser.add_argument("--scenario", type=pathlib.Path, required=True)
    parser.add_argument("--recording", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("--reports", type=pathlib.Path, required=True, metavar="FOLDER")
    parser.add_argument("--bounds", type=pathlib.Path, metavar="CSV")
    parser.add_argument("command", nargs="+", help="the replaying program, and what runs it")
    args = parser.parse_args()

    record(args)
    said = replay(args)
    unit = said[0][1]
    frames = [[int(count) for count in line[1:]] for line in said if line[0] == "frame"]
    found, pairs, members = differences(args.recording)
    bounds = read_bounds(args.bounds, args.name)

    lines = [f"Replay of {args.scenario.name} on {args.name}: {pairs} pairs, {2 * pairs} frames; "
             f"{members} members of each pair's answers, {len(found) or 'none'} not the host's.", "",
             f"| {unit} | median | max | bound |", "|---|--:|--:|--:|"]
    measurements = []
    for stage, columns in (("frame to ellipse", ELLIPSE), ("frame to sphere", SPHERE),
                           ("poses and ball", BALL)):
        counts = [frame[column] for frame in frames for column in columns]
        median, most, bound = int(statistics.median(counts)), max(counts), bounds.get(stage)
        lines.append(f"| {stage} | {median} | {most} | {'' if bound is None else bound} |")
        measurements += [(f"{stage}, median", median), (f"{stage}, max", most)]
        if bound is not None and most > bound:
            found.append(f"{stage} took {most} instructions, over the bound of {bound}")
    text = "\n".join(lines) + "\n"
    (args.reports / f"replay_{args.name}.md").write_text(text)
    print(text)
    for label, value in measurements:
        print(f'<CTestMeasurement type="numeric/double" name="{label}">{value}</CTestMeasurement>')
    for line in found[:20]:
        print(f"replay: {line}", file=sys.stderr)
    return 1 if found or not frames else 0


if __name__ == "__main__":
    sys.exit(main())
