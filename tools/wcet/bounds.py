# SPDX-License-Identifier: MIT
"""The source's bounds, for the loops of the machine code.

A loop of the code is told to be one of the source by the branches that leave it and
those that go back: each is of the line of a loop's head (its condition), in a
function or in an inlined copy of one.  What the compiler makes of a loop of the
source (unrolled, peeled, split, once more for another case) goes round at most as
often, so each piece gets the whole bound.  A loop that is none of the source's is one
in which the compiler copies a struct: its rounds follow from its registers (values.py),
or it is refused.
"""
import collections

from . import source
from .code import Refused

Instance = collections.namedtuple("Instance", "copy loop")
"""A loop of the source in one inlined copy of its function."""

_READS_OR_WRITES = {"ldr", "ldrb", "ldrh", "ldrsb", "ldrsh", "ldrd", "ldm", "str", "strb", "strh",
                    "strd", "stm"}


def _touches_memory(insn):
    """True of a load or a store, but not of the compiler's own on the stack."""
    return insn.name in _READS_OR_WRITES and "sp" not in insn.text


class Annotations:
    """Loops and notes of source files."""

    def __init__(self, paths):
        self.notes, self._at = {}, {}
        for path in paths:
            try:
                loops, self.notes[path] = source.read_loops(path)
            except source.Malformed as error:
                raise Refused(f"{path}: {error}") from None
            at = self._at[path] = collections.defaultdict(list)
            for loop in loops:
                for line in range(loop.lines[0], loop.lines[1] + 1):
                    at[line].append(loop)
        self.values = {}

    def loops_at(self, path, line):
        """Loops of a line, outer ones first."""
        return self._at[path].get(line, ()) if path in self._at else ()

    def expressions(self):
        """path -> every expression of its notes."""
        return {path: [clause.expression for note in notes for clause in note.clauses]
                for path, notes in self.notes.items() if notes}

    def value(self, path, clause):
        if clause.expression not in self.values[path]:
            raise Refused(f"{path}: {clause.expression} is not declared")
        return self.values[path][clause.expression]

    def check_values(self):
        """What `= N` says must be so."""
        for path, notes in self.notes.items():
            for note in notes:
                for clause in note.clauses:
                    value = self.values[path].get(clause.expression)
                    if None not in (clause.value, value) and clause.value != value:
                        raise Refused(f"{path}:{note.first}: {clause.expression} is {value}, "
                                      f"not {clause.value}")

    def statement_notes(self, path, line):
        """`at most` notes that are on a line, or on the one before it alone."""
        return [note for note in self.notes.get(path, ()) if note.kind == "at most"
                and note.first <= line <= note.last + 1]

    def bytes_of(self, frames):
        """What a `bytes:` comment beside a call says, or None."""
        for frame in reversed(frames):
            for note in self.notes.get(frame.path, ()):
                if note.kind == "bytes" and note.first - 1 <= frame.line <= note.last + 1:
                    return self.value(frame.path, note.clauses[0])
        return None


class Matched:
    """The bounds of one loop of the code.  rounds: at most, each time it is come to; limits:
    [(clause, rounds)], those that hold elsewhere; bodies: places in the source loop's body."""

    def __init__(self, instances, rounds, limits, bodies):
        self.instances, self.rounds, self.limits, self.bodies = instances, rounds, limits, bodies

    @property
    def only(self):
        """The loop of the source in its copy, where there is one only, or None."""
        return next(iter(self.instances)) if len(self.instances) == 1 else None

    @property
    def loop(self):
        return next(iter(self.instances)).loop


class Matcher:
    """Finds the bounds of a function's loops."""

    def __init__(self, annotations, lines):
        self.annotations, self.lines = annotations, lines

    def _where(self, flow, insn):
        """For messages."""
        frames = self.lines.frames(flow.function.address, insn.address)
        at = " in ".join(f"{f.path.name if f.path else '?'}:{f.line}" for f in reversed(frames))
        return f"{flow.name}: at {insn.address:#x} ({at})"

    def nest(self, flow, insn):
        """[(instance, in its head)] of an instruction, outer loops first."""
        nest = []
        for frame in self.lines.frames(flow.function.address, insn.address):
            for loop in self.annotations.loops_at(frame.path, frame.line):
                nest.append((Instance(frame.instance, loop),
                             loop.head[0] <= frame.line <= loop.head[1]))
        return nest

    def _votes(self, nests, places, flow):
        """Instances in whose heads the last instructions of these places are."""
        votes = []
        for place in places:
            nest = nests(flow.blocks[place].last)
            if nest and nest[-1][1]:
                votes.append(nest[-1][0])
        return votes

    def match(self, flow, values):
        """Loop of flow -> Matched.  `values` gives what is known of a flow's registers."""
        cache = {}

        def nests(insn):
            if insn.address not in cache:
                cache[insn.address] = self.nest(flow, insn)
            return cache[insn.address]

        instances = {}
        for loop in reversed(flow.loops):       # inner ones first
            inner = {i for child in loop.children for i in instances[child]}
            instances[loop] = self._told(flow, loop, nests, inner)
        found = {}
        for loop in flow.loops:                 # outer ones first
            if instances[loop]:
                found[loop] = self._bound(flow, loop, nests, instances[loop])
                continue
            around = instances[loop.parent] if loop.parent else set()
            copied = values(flow).rounds(loop)
            if copied is not None:              # it copies a struct: its body begins it
                found[loop] = Matched({Instance(loop.header, None)}, copied, [], [loop.header])
            else:
                instances[loop] = self._by_majority(flow, loop, nests, around)
                found[loop] = self._bound(flow, loop, nests, instances[loop])
                found[loop].limits += self._shared_limits(instances[loop], around)
        return found

    def _shared_limits(self, instances, around):
        """Of a loop that may be the one around it, or one that stands in that: in all
        rounds of the one around it goes round as often as the one, or the other, may."""
        inner = instances - around
        if len(instances) != 2 or len(inner) != 1 or len(instances & around) != 1:
            return []
        (inner,), (outer,) = inner, instances & around
        if inner.loop.parent is not outer.loop or inner.copy != outer.copy:
            return []
        once = self.annotations.value(outer.loop.path, outer.loop.note.clauses[0])
        return [(clause, max(once, self.annotations.value(inner.loop.path, clause)))
                for clause in inner.loop.note.clauses if clause.scope == "outer"]

    def _told(self, flow, loop, nests, inner):
        """Instances in whose heads the loop is left, or gone back: any of them may be it."""
        leaving = [place for place in loop.own()
                   if any(edge.target not in loop.body for edge in flow.edges[place])]
        votes = {vote for places in (leaving, loop.latches)
                 for vote in self._votes(nests, places, flow)}
        return {vote for vote in votes if vote not in inner} or votes

    def _by_majority(self, flow, loop, nests, around):
        """A loop that neither a condition leaves nor one repeats: a part of one of the
        source, which jump threading goes round apart.  Then most of it is of that loop's
        lines, of more than one of them; of the loops that those are in, any may be it, but
        none outside of that which the loop around is."""
        counts, lines, size = collections.Counter(), set(), 0
        for place in loop.own():
            for insn in flow.blocks[place].insns:
                size += 1
                counts.update(instance for instance, _ in nests(insn))
                lines.add(self.lines.place(insn.address))
        chosen = {instance for instance, count in counts.items() if 2 * count > size}
        if loop.children and not chosen:
            # It is what a loop within it is, or one that this is in.
            chosen = {instance for child in loop.children for place in child.latches
                      for instance, _ in nests(flow.blocks[place].last)}
        if not chosen or (len(lines) < 2 and not loop.children):
            raise Refused(f"{self._where(flow, flow.blocks[loop.header].insns[0])}: "
                          "a loop that is none of the source's")
        outside = set()
        for instance in around:
            outer = instance.loop.parent
            while outer:
                outside.add(Instance(instance.copy, outer))
                outer = outer.parent
        return chosen - outside or chosen

    def _bound(self, flow, loop, nests, instances):
        for instance in instances:
            if instance.loop.note is None:
                raise Refused(f"{self._where(flow, flow.blocks[loop.header].insns[0])}: the loop "
                              f"of {instance.loop} has no `bound:` comment")
        rounds, limits = 0, []
        for instance in instances:
            path, clauses = instance.loop.path, instance.loop.note.clauses
            values = [(clause, self.annotations.value(path, clause)) for clause in clauses]
            rounds = max(rounds, values[0][1])
            if len(instances) == 1:
                limits = [(c, v) for c, v in values if c.scope != "entry"]
        bodies = [place for place in loop.own()
                  if self._is_body(flow, place, nests, instances)] if len(instances) == 1 else []
        return Matched(instances, rounds, limits, bodies)

    def inlined_at(self, flow, insn):
        """Names of the functions of which an instruction is an inlined part."""
        frames = self.lines.frames(flow.function.address, insn.address)
        return tuple(frame.name for frame in frames if frame.name)

    def innermost(self, flow, insn):
        """The innermost loop of the source that an instruction is in, or None."""
        nest = self.nest(flow, insn)
        return nest[-1][0] if nest else None

    def statements(self, flow):
        """[(note, path, calls, others, looping)] of the `at most` notes beside what this flow
        does: places that end in the statement's call, and those of what was inlined for it,
        those in its loops apart."""
        found = collections.defaultdict(lambda: ([], [], []))
        for place, block in flow.blocks.items():
            for insn in block.insns:
                calls_here = insn.kind == "call" or (
                    insn is block.last and block.callee and not insn.conditional)
                if not calls_here and not _touches_memory(insn):
                    continue
                frames = self.lines.frames(flow.function.address, insn.address)
                for i, frame in enumerate(frames):
                    for note in self.annotations.statement_notes(frame.path, frame.line):
                        calls, others, looping = found[(note, frame.path)]
                        in_loop = any(self.annotations.loops_at(f.path, f.line)
                                      for f in frames[i + 1:])
                        if calls_here and i + 1 == len(frames):
                            calls.append(place)
                        elif place not in (looping if in_loop else others):
                            (looping if in_loop else others).append(place)
        return [(note, path, *places) for (note, path), places in found.items()]

    def _is_body(self, flow, place, nests, instances):
        """True of a block with something of the source loop's body that no compiler
        executes when the source does not: a load, a store or a call."""
        for insn in flow.blocks[place].insns:
            if insn.kind == "call" or _touches_memory(insn):
                if any(not in_head for instance, in_head in nests(insn) if instance in instances):
                    return True
        return False
