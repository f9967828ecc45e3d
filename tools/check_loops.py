#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Claim: every loop of the library says its bound, in words that tools/wcet.py reads.

Each `for` and `while` in lib/src has a comment that begins `bound:` on a line of its
head or on the line before; a `do` has it at its `do` or at its closing `while`.  What
stands in it, and in the `at most:` and `bytes:` comments beside statements, is in the
language of tools/wcet/source.py: an expression of constants, then words.
(That there is no goto is check_misra.sh's, no recursion stack.py's to say.)
"""
import argparse
import pathlib
import sys

sys.dont_write_bytecode = True

from wcet import source  # noqa: E402


def check_file(path, name):
    try:
        loops, _ = source.read_loops(path)
    except source.Malformed as error:
        return 0, [f"{name}: {error}"]
    return len(loops), [f"{name}:{loop.line}: no `bound:` comment"
                        for loop in loops if loop.note is None]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.parse_args()
    root = pathlib.Path(__file__).resolve().parent.parent
    loops, errors = 0, []
    for path in sorted((root / "lib" / "src").glob("**/*.[ch]")):
        found, bad = check_file(path, path.relative_to(root))
        loops += found
        errors += bad
    for error in errors:
        print(error, file=sys.stderr)
    if errors:
        print(f"check_loops: FAILED, {len(errors)} of {loops} loops without a bound that can be "
              "read; write /* bound: a named constant or the image size */ beside each",
              file=sys.stderr)
        return 1
    print(f"check_loops: {loops} loops, each with its bound")
    return 0


if __name__ == "__main__":
    sys.exit(main())
