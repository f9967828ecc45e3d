#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Instructions for a frame and for a fit, the library's beside OpenCV's.

Runs tests/bench/frame_cost under callgrind for every pipeline and frame, prints
the Markdown tables and fails when a figure of the library is over its limit.
"""
import argparse
import concurrent.futures
import sys

from callgrind_costs import measure

PIXELS = 320 * 240
# Frame, and the library's limit in instructions.
FRAMES = (("empty", None), ("plain", 450_000), ("salt", 1_000_000),
          ("checkerboard", 40 * PIXELS), ("isolated", 40 * PIXELS),
          ("comb", 40 * PIXELS), ("random", 40 * PIXELS))
PIPELINES = ("ocellus", "opencv-ccl", "opencv-contours")
# Fit, and the limit for 250 points.
FITS = (("fit-b2ac", "`ocel_fit_cracks`, `b2ac`", 4_000 + 50 * 250),
        ("fit-lcse", "`ocel_fit_cracks`, `lcse`, always perturbed", None),
        ("fit-hyper", "`ocel_fit_cracks`, `hyper`", None),
        ("points-b2ac", "`ocel_fit_points`, `b2ac`", None),
        ("points-hyper", "`ocel_fit_points`, `hyper`", None),
        ("opencv-direct", "OpenCV `fitEllipseDirect`", None))
FEW, MANY = 250, 1000
# The robust cone fit: points, and the limit for them.
CONE, CONE_LIMIT = 340, 100_000
# Limits that are not reached yet.  What tests/FIGURES.md records still holds these
# figures from rising; one that gets within its limit must leave this list.
OPEN = {"random"}


def cost(program, pipeline, frame):
    """Instructions of the one measured call, and what the program printed."""
    costs, said = measure([program, pipeline, str(frame)], "^measure_")
    if len(costs) != 1:
        sys.exit(f"frame_figures: {pipeline} {frame}: expected one measured function, "
                 f"found {sorted(costs)}")
    return next(iter(costs.values()))[0], said.strip().splitlines()[-1]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="build/host/bin/frame_cost")
    args = parser.parse_args()

    jobs = [(pipeline, frame) for frame, _ in FRAMES for pipeline in PIPELINES]
    jobs += [(fit, count) for fit, _, _ in FITS for count in (FEW, MANY)]
    jobs += [("cone", CONE), ("cone", MANY)]
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        results = pool.map(lambda job: cost(args.program, *job), jobs)
    measured = dict(zip(jobs, results))
    failed = []

    print("One 320x240 BGR frame, colour to ellipse, instructions (callgrind, gcc -O2, x86-64; "
          "`tools/figures.sh`):")
    print()
    print("| frame | ocellus | limit | a pixel | OpenCV, components and contour "
          "| OpenCV, all contours |")
    print("|---|--:|--:|--:|--:|--:|")
    for frame, limit in FRAMES:
        ours, ccl, contours = (measured[pipeline, frame][0] for pipeline in PIPELINES)
        over = limit is not None and ours > limit
        if over and frame not in OPEN:
            failed.append(f"the frame {frame} takes {ours} instructions, over {limit}")
        if not over and frame in OPEN:
            failed.append(f"the frame {frame} is within its limit now: take it out of OPEN")
        print(f"| {frame} | {ours} | {limit or ''}{', not reached' if over else ''} | {ours / PIXELS:.1f} | {ccl} | {contours} |")
    print()
    print(f"One fit of {FEW} boundary points, instructions, and what each further point takes:")
    print()
    print(f"| fit | {FEW} points | limit | each further point |")
    print("|---|--:|--:|--:|")
    for fit, title, limit in FITS:
        few, many = measured[fit, FEW][0], measured[fit, MANY][0]
        if limit is not None and few > limit:
            failed.append(f"{fit} of {FEW} points takes {few} instructions, over {limit}")
        print(f"| {title} | {few} | {limit or ''} | {(many - few) / (MANY - FEW):.1f} |")

    few, many = measured["cone", CONE][0], measured["cone", MANY][0]
    if few > CONE_LIMIT:
        failed.append(f"the cone of {CONE} points takes {few} instructions, over {CONE_LIMIT}")
    print()
    print(f"The robust cone fit, `ocel_cone_fit_cracks`, of {CONE} boundary points: {few} instructions "
          f"(limit {CONE_LIMIT}), and {(many - few) / (MANY - CONE):.1f} for each further point.")

    plain = {measured[pipeline, "plain"][1] for pipeline in PIPELINES}
    for said in sorted(plain):
        print(f"found: {said}", file=sys.stderr)
    for text in failed:
        print(f"frame_figures: {text}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
