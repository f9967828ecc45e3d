# SPDX-License-Identifier: MIT
"""The worst path of a function: implicit path enumeration (Li and Malik, "Performance
analysis of embedded software using implicit path enumeration", 1995).

Each edge of the control flow has a number of executions; what comes into a block goes
out of it, a loop's rounds are bounded, and the cost is maximised.  The numbers may be
fractions (linear programming), which can only raise the bound.  A function that is
called costs its own bound, unless a comment bounds its loops over the whole of a call
of this one: then its flow is taken in for each place from where it is called.
"""
import collections
import math

import numpy
from scipy.optimize import linprog
from scipy.sparse import coo_array

from . import helpers, timing
from .code import Refused
from .flow import EXIT, Flow
from .values import Values

MODELS = ("insn", "typ", "max")

_SOLVERS = ({"method": "highs"}, {"method": "highs-ds", "options": {"presolve": False}},
            {"method": "highs-ipm"})
"""One after the other until one ends: HiGHS 1.2 gives up on some programs by one way."""


def _plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


class _Clone:
    """A function's flow, taken into a program: the first variable of its edges.  inlined:
    the functions that the place of its call is an inlined part of."""

    def __init__(self, flow, parent, first, inlined=()):
        self.flow, self.parent, self.inlined = flow, parent, inlined
        self.entry = first      # the variable that says how often it is called
        self.variable = {}
        for place in flow.blocks:
            for i, edge in enumerate(flow.edges[place]):
                self.variable[(place, i)] = first + 1 + len(self.variable)
        self.next = first + 1 + len(self.variable)
        self.into = collections.defaultdict(list)   # place -> variables that come into it
        self.into[flow.entry].append(self.entry)
        for place, edges in flow.edges.items():
            for i, edge in enumerate(edges):
                if edge.target is not EXIT:
                    self.into[edge.target].append(self.variable[(place, i)])

    def entering(self, loop):
        """Variables of the edges that come into a loop from outside."""
        inside = {self.variable[(place, i)] for place in loop.body
                  for i, edge in enumerate(self.flow.edges[place]) if edge.target == loop.header}
        return [v for v in self.into[loop.header] if v not in inside]

    def going_back(self, loop):
        return [self.variable[(place, i)] for place in loop.latches
                for i, edge in enumerate(self.flow.edges[place]) if edge.target == loop.header]

    def within(self, names):
        """The clone of one of these functions that this one is in, or None."""
        clone = self
        while clone is not None and clone.flow.name not in names:
            clone = clone.parent
        return clone


    def whole_of(self, clause):
        """The clone over whose call a clause adds up, if this one is among what it counts."""
        if clause.through and not self.is_called_by((clause.through,)):
            return None
        return self.within(clause.names)

    def is_called_by(self, names):
        """Whether it is executed for a call of one of these, be they inlined or not."""
        clone = self
        while clone is not None:
            if clone.flow.name in names or set(clone.inlined) & set(names):
                return True
            clone = clone.parent
        return False


class _Rows:
    """Constraints, row by row: variables and their factors, and the right side."""

    def __init__(self):
        self.entries, self.right = [], []

    def add(self, terms, right=0):
        row = len(self.right)
        self.entries += [(row, variable, factor) for variable, factor in terms]
        self.right.append(right)

    def matrix(self, columns):
        if not self.right:
            return None
        rows, variables, factors = zip(*self.entries)
        return coo_array((factors, (rows, variables)), shape=(len(self.right), columns)).tocsr()


class Analysis:
    """Bounds of a program's functions, in instructions and modelled cycles (typ, max)."""

    def __init__(self, program, matcher, core):
        self.program, self.matcher, self.core = program, matcher, core
        self.table = timing.OF_COMPILER[core]
        self._flows, self._matched, self._statements, self._values = {}, {}, {}, {}
        self._bounds, self._scopes = {}, {}
        self._pending = []
        self._costs = {}

    # ---- Functions ----

    def flow(self, name):
        if name not in self._flows:
            self._flows[name] = Flow(self.program, name)
        return self._flows[name]

    def values(self, flow):
        if flow.name not in self._values:
            self._values[flow.name] = Values(flow)
        return self._values[flow.name]

    def matched(self, name):
        if name not in self._matched:
            self._matched[name] = self.matcher.match(self.flow(name), self.values)
        return self._matched[name]

    def statements(self, name):
        if name not in self._statements:
            self._statements[name] = self.matcher.statements(self.flow(name))
        return self._statements[name]

    def scopes(self, name):
        """Functions over whose calls loops in this one, or in what it calls, are bounded."""
        if name not in self._scopes:
            self._scopes[name] = set()
            if helpers.alias(self.program, name) is None:
                found = {other for bound in self.matched(name).values()
                         for clause, _ in bound.limits for other in clause.names}
                found |= {other for note, *_ in self.statements(name)
                          for clause in note.clauses for other in clause.names}
                for block in self.flow(name).blocks.values():
                    if block.callee:
                        found |= self.scopes(block.callee)
                self._scopes[name] = found
        return self._scopes[name]

    def bound(self, name, count=None):
        """(insn, typ, max) at most of one call; count: the bytes of a memcpy or memset."""
        key = (name, count)
        if name not in self.program.symbols:
            raise Refused(f"{name}: no such function; it may be inlined where it is called")
        if key not in self._bounds:
            if name in self._pending:
                raise Refused("recursion: " + " -> ".join([*self._pending, name]))
            self._pending.append(name)
            try:
                self._bounds[key] = self._solve(name, count)
            finally:
                self._pending.pop()
        return self._bounds[key]

    # ---- Costs ----

    def _insn_cost(self, insn):
        if insn.address not in self._costs:
            try:
                cost = timing.cost_of(insn, self.table)
            except timing.Unknown as error:
                raise Refused(f"at {insn.address:#x}: no timing of {error}") from None
            self._costs[insn.address] = ((1, *cost.base), (0, *cost.taken))
        return self._costs[insn.address]

    def _block_cost(self, block):
        total = (0, 0, 0)
        for insn in block.insns:
            total = _plus(total, self._insn_cost(insn)[0])
        return total

    def _callee_cost(self, flow, place):
        """Cost of what a block calls, by itself."""
        name = flow.blocks[place].callee
        helper = helpers.alias(self.program, name)
        if helper not in helpers.COPIES:
            return self.bound(name)
        count = self.values(flow).constant(place, "r2")
        if count is None:
            last = flow.blocks[place].last
            frames = self.matcher.lines.frames(flow.function.address, last.address)
            count = self.matcher.annotations.bytes_of(frames)
            if count is None:
                where = " in ".join(f"{f.path.name if f.path else '?'}:{f.line}"
                                    for f in reversed(frames))
                raise Refused(f"{flow.name}: {name} at {last.address:#x} ({where}) is for a number "
                              "of bytes that is not a constant and has no `bytes:` comment")
        return self.bound(name, count)

    # ---- The program ----

    def _solve(self, name, count):
        helper = helpers.alias(self.program, name)
        clones, equal, most = [], _Rows(), _Rows()
        costs = collections.defaultdict(lambda: (0, 0, 0))

        def take_in(function, parent, stack, inlined=()):
            clone = _Clone(self.flow(function), parent, clones[-1].next if clones else 0, inlined)
            clones.append(clone)
            flow = clone.flow
            for place, block in flow.blocks.items():
                base = self._block_cost(block)
                for variable in clone.into[place]:
                    costs[variable] = _plus(costs[variable], base)
                for i, edge in enumerate(flow.edges[place]):
                    variable = clone.variable[(place, i)]
                    if edge.taken:
                        extra = self._insn_cost(block.last)[1]
                        costs[variable] = _plus(costs[variable], extra)
                out = [(clone.variable[(place, i)], 1.0) for i in range(len(flow.edges[place]))]
                equal.add(out + [(v, -1.0) for v in clone.into[place]])
            for place, block in flow.blocks.items():
                if block.callee:
                    call(clone, place, stack)
            return clone

        def call(clone, place, stack):
            flow = clone.flow
            block = flow.blocks[place]
            calling = [clone.variable[(place, i)] for i, edge in enumerate(flow.edges[place])
                       if block.last.kind == "call" or edge.target is EXIT]
            inlined = self.matcher.inlined_at(flow, block.last)
            inside = [*stack, *inlined]
            if self.scopes(block.callee) & set(inside):
                if block.callee in stack:
                    raise Refused("recursion: " + " -> ".join([*stack, block.callee]))
                callee = take_in(block.callee, clone, [*inside, block.callee], inlined)
                equal.add([(callee.entry, 1.0)] + [(v, -1.0) for v in calling])
                return
            cost = self._callee_cost(flow, place)
            for variable in calling:
                costs[variable] = _plus(costs[variable], cost)

        take_in(name, None, [name])
        equal.add([(0, 1.0)], 1.0)
        if helper:
            self._state_rounds(clones[0], helper, count, most)
        else:
            for clone in clones:
                self._bound_loops(clone, most)
            self._bound_totals(clones, most)
            self._bound_statements(clones, most)
        return self._maximise(name, clones, costs, equal, most)

    def _state_rounds(self, clone, helper, count, most):
        loops = sorted(clone.flow.loops, key=lambda loop: min(place[0] for place in loop.body))
        rounds = helpers.rounds(helper, self.core, count)
        if len(loops) != len(rounds):
            raise Refused(f"{clone.flow.name}: {len(loops)} loops, and not the {len(rounds)} of "
                          "tools/wcet/helpers.py: another release of the C library?")
        for loop, most_rounds in zip(loops, rounds):
            most.add([(v, 1.0) for v in clone.into[loop.header]] +
                     [(v, -float(most_rounds)) for v in clone.entering(loop)])

    def _groups(self, clone):
        """(outermost, loops) of the code's loops that are parts of one of the source, one
        within the other."""
        groups = collections.defaultdict(list)
        for loop in clone.flow.loops:
            groups[self._outermost(clone, loop)].append(loop)
        return groups.items()

    def _limit(self, clone, group, rounds, entries, most):
        """At most `rounds` rounds of a group for each execution of `entries`: what goes
        back, and the first time through where the loop begins with its body; and as many
        executions of each block of the body."""
        outermost, loops = group
        come_to = [(v, -float(rounds)) for v in entries]
        most.add(self._rounds_of(clone, group) + come_to)
        for loop in loops:
            for place in self.matched(clone.flow.name)[loop].bodies:
                most.add([(v, 1.0) for v in clone.into[place]] + come_to)
            for child in loop.children:     # to come to a loop of the body is of the body
                if self._is_of_body(clone, child, outermost):
                    most.add([(v, 1.0) for v in clone.entering(child)] + come_to)

    def _is_of_body(self, clone, child, outer):
        """Whether a loop is of the source loop that stands in the body of the other's."""
        matched = self.matched(clone.flow.name)
        inner_loop, outer_loop = matched[child].only, matched[outer].only
        if not inner_loop or not outer_loop:
            return False
        insn = clone.flow.blocks[child.header].insns[0]
        nest = self.matcher.nest(clone.flow, insn)
        return (outer_loop, False) in nest and matched[child].instances != matched[outer].instances

    def _rounds_of(self, clone, group):
        """Terms whose sum is a group's rounds: executions of a block of the body that no round
        goes past, nor the last if there is such a block, or what goes back."""
        outermost, loops = group
        if len(loops) == 1:
            places = [place for place in sorted(self.matched(clone.flow.name)[outermost].bodies)
                      if clone.flow.is_in_every_round(outermost, place)]
            last = [place for place in places
                    if clone.flow.is_in_the_last_round(outermost, place)]
            if places:
                return [(v, 1.0) for v in clone.into[(last + places)[0]]]
        terms = [(v, 1.0) for loop in loops for v in clone.going_back(loop)]
        if outermost.header in self.matched(clone.flow.name)[outermost].bodies:
            terms += [(v, 1.0) for v in clone.entering(outermost)]
        return terms

    def _bound_loops(self, clone, most):
        """Rounds of each loop, each time it is come to and in all rounds of the one
        around."""
        unrolled = collections.defaultdict(list)
        for group in self._groups(clone):
            outermost = group[0]
            bound = self.matched(clone.flow.name)[outermost]
            rounds = min([bound.rounds] + [limit for clause, limit in bound.limits
                                           if clause.scope == "each" and
                                           self._is_executed_by(clone, outermost, clause.names)])
            self._limit(clone, group, rounds, clone.entering(outermost), most)
            for clause, limit in bound.limits:
                if clause.scope == "outer" and outermost.parent:
                    around = self._outermost(clone, outermost.parent)
                    self._limit(clone, group, limit, clone.entering(around), most)
                elif clause.scope == "outer" and self._is_unrolled_once(clone, outermost):
                    unrolled[(bound.only, limit)] += self._rounds_of(clone, group)
        for (_, limit), terms in unrolled.items():
            most.add(terms + [(clone.entry, -float(limit))])

    def _is_unrolled_once(self, clone, loop):
        """Whether the loop around one of the source was unrolled altogether and is in no
        other: then all that is left of the inner one is of one time through it."""
        insn = clone.flow.blocks[min(loop.latches)].last
        return len(self.matcher.nest(clone.flow, insn)) == 2

    def _is_executed_by(self, clone, loop, names):
        insn = clone.flow.blocks[loop.header].insns[0]
        return clone.is_called_by(names) or \
            bool(set(self.matcher.inlined_at(clone.flow, insn)) & set(names))

    def _outermost(self, clone, loop):
        matched = self.matched(clone.flow.name)
        while loop.parent and matched[loop.parent].instances == matched[loop].instances:
            loop = loop.parent
        return loop

    def _bound_totals(self, clones, most):
        """Rounds over all that a call does."""
        over = collections.defaultdict(list)
        for clone in clones:
            for group in self._groups(clone):
                bound = self.matched(clone.flow.name)[group[0]]
                for clause, limit in bound.limits:
                    whole = clone.whole_of(clause)
                    if clause.scope == "mean" and whole:
                        most.add(self._rounds_of(clone, group) +
                                 [(v, -float(limit)) for v in clone.entering(group[0])])
                    elif clause.scope == "total" and whole:
                        for key in {bound.loop, clause.group or bound.loop}:
                            over[(whole, key, limit)] += self._rounds_of(clone, group)
        self._add_up_groups(clones, over)
        for (whole, _, limit), terms in over.items():
            most.add(terms + [(whole.entry, -float(limit))])

    def _add_up_groups(self, clones, over):
        """Statements that are counted among a group: each by its call, or by the first of its
        places, which are executed no more often than it, or where all of it is a loop by what
        comes to that."""
        for clone in clones:
            for note, path, calls, others, looping in self.statements(clone.flow.name):
                for clause in note.clauses:
                    whole = clone.whole_of(clause)
                    if clause.group and whole:
                        limit = self.matcher.annotations.value(path, clause)
                        if calls or others:
                            come_to = clone.into[clone.flow.first_of(calls or others)]
                        else:
                            come_to = self._coming_to_loop(clone, looping)
                        over[(whole, clause.group, limit)] += [(v, 1.0) for v in come_to]

    def _coming_to_loop(self, clone, places):
        """Variables of what comes to the one loop that all these places are in."""
        first = clone.flow.first_of(places)
        innermost = [loop for loop in clone.flow.loops if first in loop.body][-1]
        outermost = self._outermost(clone, innermost)
        if self.matched(clone.flow.name)[outermost].loop.parent or \
                any(place not in outermost.body for place in places):
            raise Refused(f"{clone.flow.name}: `at most` beside what is more than one loop")
        return clone.entering(outermost)

    def _bound_statements(self, clones, most):
        """Executions of statements: of their calls together, and of each place of what was
        inlined for them."""
        over = collections.defaultdict(list)
        for clone in clones:
            for note, path, calls, others, _ in self.statements(clone.flow.name):
                for clause in note.clauses:
                    limit = self.matcher.annotations.value(path, clause)
                    for place in calls + others:
                        entries = self._come_to(clone, clause, place)
                        if entries:
                            apart = None if place in calls else place
                            over[(tuple(entries), note, limit, apart)].append((clone, place))
        for (entries, _, limit, _), parts in over.items():
            most.add([(v, 1.0) for clone, place in parts for v in clone.into[place]] +
                     [(v, -float(limit)) for v in entries])

    def _come_to(self, clone, clause, place):
        """Variables that count for how often a statement's limit holds anew; none where it
        does not hold."""
        if clause.scope == "total":
            whole = clone.whole_of(clause)
            return [whole.entry] if whole else []
        around = [loop for loop in clone.flow.loops if place in loop.body]
        if not around:
            return []
        innermost = around[-1]
        instance = self.matcher.innermost(clone.flow, clone.flow.blocks[place].last)
        if self.matched(clone.flow.name)[innermost].instances != {instance}:
            return []
        return clone.entering(self._outermost(clone, innermost))

    def _maximise(self, name, clones, costs, equal, most):
        columns = clones[-1].next
        left_equal, left_most = equal.matrix(columns), most.matrix(columns)
        answer = []
        for model in range(len(MODELS)):
            gain = numpy.zeros(columns)
            for variable, cost in costs.items():
                gain[variable] = -cost[model]
            for how in _SOLVERS:
                solved = linprog(gain, A_ub=left_most, b_ub=most.right if most.right else None,
                                 A_eq=left_equal, b_eq=equal.right, bounds=(0, None), **how)
                if solved.status == 0:
                    break
            else:
                raise Refused(f"{name}: no bound: {solved.message}")
            answer.append(math.floor(-solved.fun + 1e-6 * max(1.0, -solved.fun)))
            if model == 0:
                self.last = (clones, costs, solved.x)
        return tuple(answer)

    def explain(self, name):
        """Where the worst path of a function, as it was solved last, spends its instructions:
        [(instructions, executions, function, source line)], most first."""
        self._bounds.pop((name, None), None)
        self.bound(name)
        clones, costs, counts = self.last
        spent = collections.defaultdict(lambda: [0.0, 0.0])
        for clone in clones:
            for place, block in clone.flow.blocks.items():
                times = sum(counts[v] for v in clone.into[place])
                path, line = self.matcher.lines.place(block.last.address)
                cost = sum(counts[v] * costs[v][0] for v in clone.into[place])
                cost += sum(counts[v] * costs[v][0] for (source, _), v in clone.variable.items()
                            if source == place and clone.flow.edges[place] and
                            v not in {x for vs in clone.into.values() for x in vs})
                where = (clone.flow.name, f"{path.name if path else '?'}:{line}",
                         block.callee or "")
                spent[where][0] += cost
                spent[where][1] = max(spent[where][1], times)
        return sorted(((cost, times, *where) for where, (cost, times) in spent.items()),
                      reverse=True)
