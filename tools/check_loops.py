#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Claim: every loop of the library says its bound.

Each `for` and `while` in lib/src has a comment that begins `bound:` on its line
or on the line before; a `do` has it at its `do` or at its closing `while`.
(That there is no goto is check_misra.sh's, no recursion stack.py's to say.)
"""
import argparse
import pathlib
import re
import sys

LOOP = re.compile(r"\b(for|while)\s*\(")
BOUND = re.compile(r"/\*\s*bound:\s*\S")
TOKEN = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'', re.DOTALL)


def without_comments(text):
    """The text with comments and literals blanked, line breaks kept."""
    return TOKEN.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def check_text(name, text):
    lines = text.splitlines()
    # A comment of several lines belongs to the line on which it ends.
    said = set()
    for match in re.finditer(r"/\*.*?\*/", text, re.DOTALL):
        if BOUND.search(match.group()):
            first = text.count("\n", 0, match.start())
            last = text.count("\n", 0, match.end())
            said.update(range(first, last + 1))
    errors, loops = [], 0
    for number, code in enumerate(without_comments(text).splitlines()):
        for _ in LOOP.finditer(code):
            loops += 1
            if number not in said and number - 1 not in said:
                errors.append(f"{name}:{number + 1}: no `bound:` comment: {lines[number].strip()}")
    return loops, errors


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.parse_args()
    root = pathlib.Path(__file__).resolve().parent.parent
    loops, errors = 0, []
    for path in sorted((root / "lib" / "src").glob("**/*.[ch]")):
        found, bad = check_text(path.relative_to(root), path.read_text())
        loops += found
        errors += bad
    for error in errors:
        print(error, file=sys.stderr)
    if errors:
        print(f"check_loops: FAILED, {len(errors)} of {loops} loops without a bound; write "
              "/* bound: a named constant or the image size */ beside each", file=sys.stderr)
        return 1
    print(f"check_loops: {loops} loops, each with its bound")
    return 0


if __name__ == "__main__":
    sys.exit(main())
