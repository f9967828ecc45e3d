#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The worst-case stack of each public function, from what GCC says of each.

Reads the .ci files of gcc -fstack-usage -fcallgraph-info=su,da and adds up
each function's own frame and the deepest of its callees.  Fails when the depth
is not a constant: a recursion, an indirect call, or a frame of dynamic size.
A function of the C library or of libgcc counts LIBRARY_BYTES.
"""
import argparse
import pathlib
import re
import sys

NODE = re.compile(r'node: \{ title: "([^"]+)" label: "([^"]*)"')
EDGE = re.compile(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"')
FRAME = re.compile(r"(\d+) bytes \(([a-z, ]+)\)")
COMMENTS = re.compile(r"/\*.*?\*/", re.DOTALL)
DECLARED = re.compile(r"\b(ocel_[a-z0-9_]+)\(")

LIBRARY_BYTES = 32


def public_functions(include):
    """Every function that a header in the folder declares, sorted."""
    return sorted({name for header in include.glob("**/*.h")
                   for name in DECLARED.findall(COMMENTS.sub("", header.read_text()))})


def ci_files(objects):
    """The .ci file beside each object file."""
    paths = [path.with_suffix(".ci") for path in objects]
    absent = [str(path) for path in paths if not path.exists()]
    if absent:
        sys.exit(f"stack: no {absent[0]}: compile with -fstack-usage -fcallgraph-info=su,da")
    return paths


class Unbounded(Exception):
    pass


class Graph:
    """frames: title -> (bytes, kind); calls: title -> set of titles.  A title is a
    function's name; a static one's has its file before it."""

    def __init__(self, paths):
        self.frames, self.calls, self.done = {}, {}, {}
        for path in paths:
            text = path.read_text()
            for title, label in NODE.findall(text):
                frame = FRAME.search(label)
                if frame:
                    self.frames[title] = (int(frame.group(1)), frame.group(2))
            for source, target in EDGE.findall(text):
                self.calls.setdefault(source, set()).add(target)
        self.titles = {title.rpartition(":")[2]: title for title in self.frames}

    def frame(self, name):
        return self.frames[self.titles[name]][0]

    def depth(self, name):
        """(bytes, deepest chain of titles) of one function."""
        return self._depth(self.titles.get(name, name), [])

    def _depth(self, title, path):
        """Post-order, memoised."""
        if title in self.done:
            return self.done[title]
        if title in path:
            raise Unbounded("recursion: " + " -> ".join(path[path.index(title):] + [title]))
        if title == "__indirect_call":
            raise Unbounded("a call through a pointer in " + path[-1])
        if title not in self.frames:
            return LIBRARY_BYTES, [title]
        own, kind = self.frames[title]
        if kind not in ("static", "dynamic,bounded"):
            raise Unbounded(f"{title} has a frame of {kind} size")
        deepest = (0, [])
        for callee in sorted(self.calls.get(title, ())):
            deepest = max(deepest, self._depth(callee, path + [title]))
        self.done[title] = (own + deepest[0], [title] + deepest[1])
        return self.done[title]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ci", nargs="+", type=pathlib.Path, help=".ci files")
    parser.add_argument("--public", type=pathlib.Path, required=True, metavar="FOLDER",
                        help="report the functions that the headers there declare")
    parser.add_argument("--limit", type=int, default=0, metavar="BYTES",
                        help="fail when a reported function needs more")
    parser.add_argument("--chains", action="store_true", help="show the deepest chain of each")
    args = parser.parse_args()

    graph = Graph(args.ci)
    failed = False
    for name in public_functions(args.public):
        if name not in graph.frames:
            print(f"stack: not in the archive: {name}", file=sys.stderr)
            failed = True
            continue
        try:
            size, chain = graph.depth(name)
        except Unbounded as error:
            print(f"stack: {name}: {error}", file=sys.stderr)
            failed = True
            continue
        tail = "  " + " > ".join(chain[1:]) if args.chains else ""
        print(f"{name} {size}{tail}")
        if args.limit and size > args.limit:
            print(f"stack: {name} needs {size} bytes, over {args.limit}: {' > '.join(chain)}",
                  file=sys.stderr)
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
