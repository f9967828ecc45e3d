#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares the MISRA ledger with the findings, or writes their counts into it.

The ledger's table has the columns Rule, Count, Places and Reason; a place is
`file:count`.  The findings are lines FILE:LINE:COLUMN:ID:MESSAGE of cppcheck.
"""
import argparse
import collections
import pathlib
import re
import sys

ROW = re.compile(r"^\|\s*(?P<rule>[0-9]+\.[0-9]+|[A-Za-z]+)\s*\|\s*(?P<count>\d+)\s*\|"
                 r"\s*(?P<places>[^|]*?)\s*\|\s*(?P<reason>[^|]*?)\s*\|$")


def read_findings(path):
    """rule -> file name -> count."""
    found = collections.defaultdict(collections.Counter)
    for line in path.read_text().splitlines():
        file, _, _, rule, _ = line.split(":", 4)
        found[rule.removeprefix("misra-c2012-")][pathlib.PurePosixPath(file).name] += 1
    return found


def places_text(counter):
    return ", ".join(f"{name}:{count}" for name, count in sorted(counter.items()))


def rule_order(rule):
    return tuple(int(n) for n in rule.split(".")) if rule[0].isdigit() else (1000, rule)


def row_text(rule, counter, reason):
    return f"| {rule} | {sum(counter.values())} | {places_text(counter)} | {reason} |"


def check(rows, found):
    errors = []
    for rule in sorted(set(rows) | set(found), key=rule_order):
        if rule not in rows:
            errors.append(f"{rule}: found {places_text(found[rule])}, not in the ledger")
        elif rule not in found:
            errors.append(f"{rule}: in the ledger, but no longer found; take the row out")
        else:
            row, total = rows[rule], sum(found[rule].values())
            if int(row["count"]) != total or row["places"] != places_text(found[rule]):
                errors.append(f"{rule}: ledger says {row['count']} ({row['places']}), "
                              f"found {total} ({places_text(found[rule])})")
            if row["reason"] in ("", "TODO"):
                errors.append(f"{rule}: no reason given")
    return errors


def update(path, rows, found):
    """Rewrites the rows in place; new rules get the reason TODO."""
    lines = path.read_text().splitlines()
    table = [row_text(rule, found[rule], rows[rule]["reason"] if rule in rows else "TODO")
             for rule in sorted(found, key=rule_order)]
    head = next(i for i, line in enumerate(lines) if line.startswith("|---"))
    tail = head + 1
    while tail < len(lines) and lines[tail].startswith("|"):
        tail += 1
    path.write_text("\n".join(lines[:head + 1] + table + lines[tail:]) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    mode = parser.add_mutually_exclusive_group(required=True)
    mode.add_argument("--check", action="store_true")
    mode.add_argument("--update", action="store_true")
    parser.add_argument("ledger", type=pathlib.Path)
    parser.add_argument("findings", type=pathlib.Path)
    args = parser.parse_args()

    rows = {m["rule"]: m for m in map(ROW.match, args.ledger.read_text().splitlines()) if m}
    found = read_findings(args.findings)
    if args.update:
        update(args.ledger, rows, found)
        return 0
    errors = check(rows, found)
    for error in errors:
        print(f"{args.ledger}: {error}", file=sys.stderr)
    if errors:
        print("check_misra: FAILED. Mend the code, or write the deviation down: "
              "tools/check_misra.sh --list RULE shows the places, --update counts them.",
              file=sys.stderr)
        return 1
    total = sum(sum(counter.values()) for counter in found.values())
    print(f"check_misra: {total} findings of {len(found)} rules, all in the ledger")
    return 0


if __name__ == "__main__":
    sys.exit(main())
