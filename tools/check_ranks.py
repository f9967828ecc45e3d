#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Claim: the library's files include only files of a lower rank, and besides
their own stage only the base; so no stage includes another.

lib/ranks.txt gives each module its stage and rank, and lib/src has a folder for
each stage.  A module is a name: colour.c, and colour.h in src or include, are
the module colour and may include each other.  The stage eye may include every stage.  System headers must be
among stdint.h, stdbool.h, stddef.h and string.h.  lib/sources.txt must list
every .c file.
"""
import argparse
import pathlib
import re
import sys

SYSTEM = {"stdint.h", "stdbool.h", "stddef.h", "string.h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def read_ranks(path):
    ranks, uses, errors = {}, {}, []
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split("#")[0].split()
        if not line:
            continue
        if line[0] == "uses":
            uses[line[1].rstrip(":")] = set(line[2:])
            continue
        stage, rank, *modules = line
        for module in modules:
            if module in ranks:
                errors.append(f"{path}:{number}: {module} stands here twice")
            ranks[module] = (stage, int(rank))
    return ranks, uses, errors


def check_file(path, ranks, uses):
    module = path.stem
    if module not in ranks:
        return [f"{path}: no rank; add {module} to lib/ranks.txt"]
    stage, rank = ranks[module]
    errors = []
    for bracket, name in INCLUDE.findall(path.read_text()):
        if bracket == "<" and not name.startswith("ocellus/"):
            if name not in SYSTEM:
                errors.append(f"{path}: <{name}> is not among {', '.join(sorted(SYSTEM))}")
            continue
        other = pathlib.PurePosixPath(name).stem
        if other not in ranks:
            errors.append(f"{path}: includes {name}, which has no rank in lib/ranks.txt")
        elif other != module:
            other_stage, other_rank = ranks[other]
            if other_rank >= rank:
                errors.append(f"{path}: rank {rank} includes {name} of rank {other_rank}; "
                              "move what it needs into a lower module")
            if other_stage not in {"base", stage} | uses.get(stage, set()):
                errors.append(f"{path}: stage {stage} includes {name} of stage {other_stage}, "
                              "which lib/ranks.txt does not let it use; stages meet in types.h")
    return errors


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.parse_args()
    root = pathlib.Path(__file__).resolve().parent.parent
    lib = root / "lib"
    ranks, uses, errors = read_ranks(lib / "ranks.txt")
    files = sorted([*lib.glob("src/**/*.[ch]"), *lib.glob("include/**/*.h")])
    for path in files:
        errors += [e.replace(f"{root}/", "") for e in check_file(path, ranks, uses)]
    listed = [line for line in (lib / "sources.txt").read_text().split() if line[0] != "#"]
    for path in sorted(lib.glob("src/**/*.[ch]")):
        name = str(path.relative_to(lib))
        stage = ranks.get(path.stem, ("base", 0))[0]
        if path.parent.name != stage:
            errors.append(f"lib/{name}: its stage is {stage}; move it to lib/src/{stage}/")
        if path.suffix == ".c" and name not in listed:
            errors.append(f"lib/{name}: not in lib/sources.txt")
    for name in listed:
        if not (lib / name).is_file():
            errors.append(f"lib/sources.txt: no file {name}")
    for module in ranks:
        if not any(path.stem == module for path in files):
            errors.append(f"lib/ranks.txt: no file of the name {module}")
    for error in errors:
        print(error, file=sys.stderr)
    if errors:
        print(f"check_ranks: FAILED, {len(errors)} findings", file=sys.stderr)
        return 1
    print(f"check_ranks: {len(files)} files, {len(set(ranks.values()))} ranks of {len({s for s, _ in ranks.values()})} stages, all in order")
    return 0


if __name__ == "__main__":
    sys.exit(main())
