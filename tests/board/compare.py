#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the corpus and compares its hashes with the recorded ones.

usage: compare.py EXPECTED COMMAND...

A line is a name and 16 hexadecimal digits.  A program may say only some of the
groups; a name that is not recorded and does not end a hash ("stack") is shown.
"""
import re
import subprocess
import sys

LINE = re.compile(r"^(\w+) ([0-9a-f]{16})$", re.M)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        expected = dict(LINE.findall(file.read()))
    run = subprocess.run(sys.argv[2:], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                         check=False)
    got = dict(LINE.findall(run.stdout))
    failed = run.returncode != 0 or not got
    for name, value in got.items():
        if name == "stack":
            print(f"stack: {int(value, 16)} bytes at most")
            continue
        same = expected.get(name) == value
        failed = failed or not same
        print(f"{name:8} {value} {'as recorded' if same else 'NOT ' + str(expected.get(name))}")
    if failed:
        print(run.stdout, run.stderr, f"exit code {run.returncode}", sep="\n")
        print("The results' bits are not those recorded.  When that is meant, and the host and every\n"
              "board agree again, record them: tools/check_bits.sh --update")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
