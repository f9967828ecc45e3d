#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The worst-case stack of each function, from what GCC says of each.

Reads the .ci files of gcc -fstack-usage -fcallgraph-info=su,da and adds up
each function's own frame and the deepest of its callees.  Fails when the depth
is not a constant: a recursion, an indirect call, or a frame of dynamic size.
A function of the C library or of libgcc counts --library bytes.
"""
import argparse
import pathlib
import re
import sys

NODE = re.compile(r'node: \{ title: "([^"]+)" label: "([^"]*)"')
EDGE = re.compile(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"')
FRAME = re.compile(r"(\d+) bytes \(([a-z, ]+)\)")


def read_graph(paths):
    """frames: title -> (bytes, kind); calls: title -> set of titles."""
    frames, calls = {}, {}
    for path in paths:
        text = path.read_text()
        for title, label in NODE.findall(text):
            frame = FRAME.search(label)
            if frame:
                frames[title] = (int(frame.group(1)), frame.group(2))
        for source, target in EDGE.findall(text):
            calls.setdefault(source, set()).add(target)
    return frames, calls


class Unbounded(Exception):
    pass


def depth(title, frames, calls, library, done, path):
    """(bytes, deepest chain of titles) of one function; post-order, memoised."""
    if title in done:
        return done[title]
    if title in path:
        raise Unbounded("recursion: " + " -> ".join(path[path.index(title):] + [title]))
    if title == "__indirect_call":
        raise Unbounded("a call through a pointer in " + path[-1])
    if title not in frames:
        return library, [title]
    own, kind = frames[title]
    if kind not in ("static", "dynamic,bounded"):
        raise Unbounded(f"{title} has a frame of {kind} size")
    deepest = (0, [])
    for callee in sorted(calls.get(title, ())):
        deepest = max(deepest, depth(callee, frames, calls, library, done, path + [title]))
    done[title] = (own + deepest[0], [title] + deepest[1])
    return done[title]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ci", nargs="+", type=pathlib.Path, help=".ci files")
    parser.add_argument("--library", type=int, default=32, metavar="BYTES",
                        help="a call out of the archive counts this much (default 32)")
    parser.add_argument("--only", type=pathlib.Path, metavar="FILE",
                        help="report the functions that FILE lists, one a line")
    parser.add_argument("--limit", type=int, default=0, metavar="BYTES",
                        help="fail when a reported function needs more")
    parser.add_argument("--chains", action="store_true", help="show the deepest chain of each")
    args = parser.parse_args()

    frames, calls = read_graph(args.ci)
    wanted = sorted(title for title in frames if ":" not in title)
    failed = False
    if args.only:
        listed = args.only.read_text().split()
        absent = [name for name in listed if name not in frames]
        if absent:
            print(f"stack: not in the archive: {' '.join(absent)}", file=sys.stderr)
            failed = True
        wanted = [name for name in listed if name in frames]
    done = {}
    for title in wanted:
        try:
            size, chain = depth(title, frames, calls, args.library, done, [])
        except Unbounded as error:
            print(f"stack: {title}: {error}", file=sys.stderr)
            failed = True
            continue
        tail = "  " + " > ".join(chain[1:]) if args.chains else ""
        print(f"{title} {size}{tail}")
        if args.limit and size > args.limit:
            print(f"stack: {title} needs {size} bytes, over {args.limit}: {' > '.join(chain)}",
                  file=sys.stderr)
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
