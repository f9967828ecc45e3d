# SPDX-License-Identifier: MIT
"""Control flow of a function: blocks, and the natural loops among them.

A loop that can be come to at more than one place, as jump threading makes them, gets
one: what lies between another way in and the header is copied, and the copy goes to
the header (node splitting).  So a place is an address and the number of its copy.
"""
import collections

from .code import Refused, is_return

EXIT = None

Edge = collections.namedtuple("Edge", "source target taken")
"""From place to place (EXIT leaves the function); taken: by a jump that could also not
have been taken, whose extra cost it carries."""

COPIES_MAX = 400
"""Blocks that splitting may add to a function."""


class Block:
    """Instructions that are executed one after the other; a call ends one."""

    def __init__(self, insns):
        self.insns = insns
        self.callee = None      # name, when the block ends in a call or a jump to a function

    @property
    def last(self):
        return self.insns[-1]


class Loop:
    """A natural loop: its header, its places, those its back edges come from."""

    def __init__(self, header, body, latches):
        self.header, self.body, self.latches = header, body, latches
        self.parent = None
        self.children = []

    def own(self):
        """Places in no loop within this one."""
        return self.body.difference(*(child.body for child in self.children))


def _components(nodes, successors):
    """Strongly connected components with a cycle (Tarjan 1972, without recursion)."""
    index, low, on_stack, stack, found = {}, {}, set(), [], []
    for root in nodes:
        if root in index:
            continue
        waiting = [(root, iter(successors(root)))]
        index[root] = low[root] = len(index)
        stack.append(root)
        on_stack.add(root)
        while waiting:
            node, rest = waiting[-1]
            for target in rest:
                if target not in nodes:
                    continue
                if target not in index:
                    index[target] = low[target] = len(index)
                    stack.append(target)
                    on_stack.add(target)
                    waiting.append((target, iter(successors(target))))
                    break
                if target in on_stack:
                    low[node] = min(low[node], index[target])
            else:
                waiting.pop()
                if waiting:
                    above = waiting[-1][0]
                    low[above] = min(low[above], low[node])
                if low[node] == index[node]:
                    members = set()
                    while node not in members:
                        members.add(stack.pop())
                    on_stack -= members
                    if len(members) > 1 or node in successors(node):
                        found.append(members)
    return found


class Flow:
    """Blocks, edges and loops of a function of a wcet.code.Program."""

    def __init__(self, program, name):
        self.program, self.name = program, name
        self.function = program.function(name)
        self.entry = (self.function.address, 0)
        self.blocks = {}        # place -> Block
        self.edges = {}         # place -> its edges
        self.copies = 0
        self._find_blocks()
        self._split(set(self.blocks), self.entry)
        self._drop_unreached()
        self.loops = []
        self._find_loops(set(self.blocks), None)

    # ---- Blocks ----

    def _inside(self, address):
        return address in self.function.insns

    def _leaders(self):
        insns = self.function.insns
        leaders = {self.function.address}
        for insn in insns.values():
            if insn.kind in ("jump", "call", "trap"):
                leaders.add(insn.address + insn.size)
            if insn.kind in ("jump", "call") and insn.target is not None and \
                    self._inside(insn.target):
                leaders.add(insn.target)
        return leaders

    def _find_blocks(self):
        leaders, blocks, run = self._leaders(), {}, []
        for insn in self.function.insns.values():
            if run and (insn.address in leaders or run[-1].address + run[-1].size != insn.address):
                blocks[run[0].address] = Block(run)
                run = []
            run.append(insn)
        if run:
            blocks[run[0].address] = Block(run)
        waiting = [self.entry]
        while waiting:
            place = waiting.pop()
            if place in self.blocks:
                continue
            if place[0] not in blocks:
                raise Refused(f"{self.name}: runs on to {place[0]:#x}, which is not its code")
            self.blocks[place] = blocks[place[0]]
            self.edges[place] = self._connect(place)
            waiting += self.successors(place)

    def _connect(self, place):
        block = self.blocks[place]
        last = block.last
        after = (last.address + last.size, 0)
        if last.kind == "call" and self._inside(last.target) and \
                last.target != self.function.address:
            return [Edge(place, (last.target, 0), False)]   # Armv6-M's far jump is a BL
        if last.kind == "call":
            block.callee = self._callee(last)
            return [Edge(place, after, False)]
        if last.kind == "trap":
            return [Edge(place, EXIT, False)]
        if last.kind != "jump":
            return [Edge(place, after, False)]
        edges = [Edge(place, after, False)] if last.conditional else []
        return edges + [Edge(place, self._jump(block), last.conditional)]

    def _jump(self, block):
        last = block.last
        if is_return(last):
            return EXIT
        if last.target is None:
            raise Refused(f"{self.name}: a jump to a computed place, {last.text}, "
                          f"at {last.address:#x}")
        if self._inside(last.target):
            return (last.target, 0)
        block.callee = self._callee(last)
        return EXIT

    def _callee(self, insn):
        if insn.target is None:
            raise Refused(f"{self.name}: a call through a pointer, {insn.text}, "
                          f"at {insn.address:#x}")
        if insn.target not in self.program.names:
            raise Refused(f"{self.name}: {insn.text} at {insn.address:#x} goes into the middle of "
                          f"{self.program.function_of(insn.target)}")
        return self.program.names[insn.target]

    def successors(self, place):
        return [edge.target for edge in self.edges[place] if edge.target is not EXIT]

    def _reached_before(self, loop, place):
        """Places of a loop that its header comes to without going through a place."""
        reached, waiting = set(), [loop.header]
        while waiting:
            at = waiting.pop()
            if at != place and at not in reached:
                reached.add(at)
                waiting += [t for t in self.successors(at) if t in loop.body and t != loop.header]
        return reached

    def is_in_every_round(self, loop, place):
        """Whether every way from a loop's header back to it goes through a place."""
        return not self._reached_before(loop, place) & loop.latches

    def is_in_the_last_round(self, loop, place):
        """Whether every way from a loop's header out of it goes through a place, too."""
        return not any(edge.target not in loop.body
                       for at in self._reached_before(loop, place) for edge in self.edges[at])

    def first_of(self, places):
        """Of some places that which is fewest blocks away from the entry."""
        distance, waiting = {self.entry: 0}, collections.deque([self.entry])
        while waiting:
            place = waiting.popleft()
            for target in self.successors(place):
                if target not in distance:
                    distance[target] = distance[place] + 1
                    waiting.append(target)
        return min(places, key=lambda place: (distance[place], place))

    def entering(self, places, at=None):
        """Edges that come into a set of places from outside, all or those to one of them."""
        return [edge for place, edges in self.edges.items() if place not in places
                for edge in edges if edge.target in places and at in (None, edge.target)]

    # ---- One way into each loop ----

    def _split(self, nodes, entry):
        for members in _components(nodes, self.successors):
            ways_in = {edge.target for edge in self.entering(members)}
            if entry in members:
                ways_in.add(entry)
            header = min(ways_in, key=lambda place: (-self._entries(members, place), place))
            if entry in members:
                header = entry
            if len(ways_in) > 1:
                copied = self._copy_ways_in(members, header, ways_in - {header})
                self._split(copied, None)
            self._split(members - {header}, None)

    def _entries(self, members, place):
        """Of the ways in, the header is the one that most of the loop jumps back to."""
        return sum(1 for member in members for target in self.successors(member)
                   if target == place)

    def _copy_ways_in(self, members, header, others):
        """Copies what the other ways in reach without the header; returns the copies."""
        reached, waiting = set(), list(others)
        while waiting:
            place = waiting.pop()
            if place not in reached:
                reached.add(place)
                waiting += [t for t in self.successors(place) if t in members and t != header]
        outside = self.entering(members)
        self.copies += len(reached)
        if self.copies > COPIES_MAX:
            raise Refused(f"{self.name}: a loop with more than one way in, "
                          f"at {header[0]:#x}, that cannot be unravelled")
        number = max(place[1] for place in self.blocks) + 1
        copy_of = {place: (place[0], number) for place in reached}
        for place, copy in copy_of.items():
            self.blocks[copy] = self.blocks[place]
            self.edges[copy] = [Edge(copy, copy_of.get(edge.target, edge.target), edge.taken)
                                for edge in self.edges[place]]
        for edge in outside:
            if edge.target in others:
                self.edges[edge.source] = [
                    Edge(e.source, copy_of[e.target], e.taken) if e == edge else e
                    for e in self.edges[edge.source]]
        return set(copy_of.values())

    def _drop_unreached(self):
        reached, waiting = set(), [self.entry]
        while waiting:
            place = waiting.pop()
            if place not in reached:
                reached.add(place)
                waiting += self.successors(place)
        self.blocks = {place: self.blocks[place] for place in reached}
        self.edges = {place: self.edges[place] for place in reached}

    # ---- Loops ----

    def _find_loops(self, nodes, parent):
        """Loops among the nodes, outer ones first.  A component has one way in, its
        header; those within are the components that are left without it."""
        for members in _components(nodes, self.successors):
            ways_in = {edge.target for edge in self.entering(members)}
            if self.entry in members:
                ways_in.add(self.entry)
            if len(ways_in) != 1:
                raise Refused(f"{self.name}: a loop with {len(ways_in)} ways in, "
                              f"at {min(members)[0]:#x}")
            header = ways_in.pop()
            latches = {place for place in members if header in self.successors(place)}
            loop = Loop(header, members, latches)
            loop.parent = parent
            if parent:
                parent.children.append(loop)
            self.loops.append(loop)
            self._find_loops(members - {header}, loop)
