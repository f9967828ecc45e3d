# SPDX-License-Identifier: MIT
"""What is known of registers: a constant, or a constant more than what something else is.

It answers two questions: how many bytes a call of memcpy or memset is for, and how
often a loop goes round that the compiler made to copy a struct.  A value is a pair of
a symbol and an offset; the symbol None makes it a constant.  A symbol stands for what
one instruction gave, or for what came together at one place, the last time that this
happened.
"""
import collections
import re

_IMMEDIATE = re.compile(r"^#(-?(?:0x[0-9a-f]+|\d+))$")
_LITERAL = re.compile(r"^\[pc, #((?:0x[0-9a-f]+|\d+))\]$")
_WRITE_BACK = re.compile(r"^\[(\w+), #(-?(?:0x[0-9a-f]+|\d+))\]!$")
_REGISTERS = (*(f"r{i}" for i in range(9)), "sb", "sl", "fp", "ip", "sp", "lr")
_CALL_CLOBBERS = ("r0", "r1", "r2", "r3", "ip", "lr")
_WRITES_NONE = {"cmp", "cmn", "tst", "teq", "str", "strb", "strh", "strd", "push", "stm", "b", "bx",
                "cbz", "cbnz", "it", "nop", "udf", "dmb"}
_WRITES_TWO = {"ldrd", "umull", "smull", "umlal", "smlal", "umaal"}
_FOLDED = {"lsl": lambda a, b: a << b, "lsr": lambda a, b: a >> b, "orr": lambda a, b: a | b,
           "and": lambda a, b: a & b, "mul": lambda a, b: a * b}


def _sets_flags(insn):
    mnemonic = insn.text.split(" ")[0]
    return insn.name in ("cmp", "cmn", "tst", "teq") or mnemonic == insn.name + "s"


def _operands(text):
    parts = text.split(" ", 1)
    if len(parts) == 1:
        return []
    return [part.strip() for part in re.split(r",\s*(?![^\[{]*[\]}])", parts[1])]


def _value(operand, state):
    immediate = _IMMEDIATE.match(operand)
    return (None, int(immediate.group(1), 0)) if immediate else state.get(operand)


def _sum(left, right, sign):
    """left + sign * right, when that is a value."""
    if left is None or right is None:
        return None
    if right[0] is None:
        offset = left[1] + sign * right[1]
        return (left[0], offset & 0xFFFFFFFF if left[0] is None else offset)
    if left[0] is None and sign > 0:
        return (right[0], left[1] + right[1])
    return None


def _result(insn, operands, state, program):
    """The value of what the instruction computes, or None."""
    literal = _LITERAL.match(operands[1]) if len(operands) == 2 else None
    if insn.name == "ldr" and literal:
        return (None, program.word_at((insn.address + 4 & ~3) + int(literal.group(1), 0)))
    if insn.name in ("mov", "movw") and len(operands) == 2:
        return _value(operands[1], state)
    if len(operands) not in (2, 3):
        return None
    left, right = _value(operands[-2], state), _value(operands[-1], state)
    if insn.name in ("add", "addw", "sub", "subw"):
        return _sum(left, right, 1 if insn.name.startswith("add") else -1)
    if insn.name in _FOLDED and left and right and left[0] is None and right[0] is None:
        return (None, _FOLDED[insn.name](left[1], right[1]) & 0xFFFFFFFF)
    return None


def _set(state, register, value, symbol):
    """Writes a register; without a known value it gets `symbol`, which then means no
    other's."""
    if value is None:
        for other in [r for r, v in state.items() if v[0] == symbol]:
            del state[other]
        value = (symbol, 0)
    state[register] = value


def _advance(insn, operands, state):
    """Address registers that loads and stores move on."""
    if insn.name in ("ldm", "stm") and operands and operands[0].endswith("!"):
        base = operands[0].rstrip("!")
        step = 4 * len(operands[1].strip("{}").split(","))
    elif len(operands) >= 3 and operands[-2].startswith("[") and operands[-1].startswith("#"):
        base, step = operands[-2].strip("[]"), int(operands[-1][1:], 0)
    else:
        moved = [m for m in map(_WRITE_BACK.match, operands) if m]
        if not moved:
            return
        base, step = moved[0].group(1), int(moved[0].group(2), 0)
    if "db" in insn.text.split(" ")[0]:
        step = -step
    _set(state, base, _sum(state.get(base), (None, step), 1), ("v", insn.address, base))


def step(insn, state, program):
    """Brings the registers' values to after an instruction."""
    operands = _operands(insn.text)
    if insn.kind == "call":
        for register in _CALL_CLOBBERS:
            _set(state, register, None, ("v", insn.address, register))
        return
    if insn.name in ("pop", "ldm", "push", "stm"):
        listed = re.findall(r"\w+", operands[-1]) if insn.name in ("pop", "ldm") else ()
        _advance(insn, operands, state)
        for register in listed:
            _set(state, register, None, ("v", insn.address, register))
        if insn.name in ("pop", "push"):
            change = 4 * len(re.findall(r"\w+", operands[-1])) * (1 if insn.name == "pop" else -1)
            _set(state, "sp", _sum(state.get("sp"), (None, change), 1), ("v", insn.address, "sp"))
        return
    if insn.name not in _WRITES_NONE and operands:
        value = None if insn.conditional else _result(insn, operands, state, program)
        count = 2 if insn.name in _WRITES_TWO else 1
        for register in operands[:count]:
            _set(state, register, value, ("v", insn.address, register))
    _advance(insn, operands, state)


def _join(place, known, arriving):
    """Values where two ways meet: those that agree, and have not come from here before."""
    joined = {}
    for register in _REGISTERS:
        value, other = known.get(register), arriving.get(register)
        symbol = ("j", place, register)
        old = value is not None and value != (symbol, 0) and value[0] is not None and \
            value[0][:2] == ("j", place)
        joined[register] = value if value is not None and value == other and not old else (symbol, 0)
    return joined


def _on_edge(edge, block, state):
    """Values on an edge: where a comparison came out equal, both are the same."""
    last = block.last
    if last.kind != "jump" or not last.conditional or len(block.insns) < 2:
        return state
    mnemonic, before = last.text.split(" ")[0], block.insns[-2]
    equal = (mnemonic.startswith("bne") and not edge.taken) or \
        (mnemonic.startswith("beq") and edge.taken)
    if not equal or before.name != "cmp" or before.conditional:
        return state
    operands = _operands(before.text)
    value = _value(operands[1], state)
    return {**state, operands[0]: value} if value is not None else state


class Values:
    """Registers' values at each place of a flow: `before` it, and `at_end`, before its last
    instruction; `leaving` its edges."""

    def __init__(self, flow):
        self.flow = flow
        self.before = {flow.entry: {r: (("entry", r), 0) for r in _REGISTERS}}
        self.at_end, self.leaving = {}, {}
        waiting = collections.deque([flow.entry])
        while waiting:
            place = waiting.popleft()
            for edge in self._pass(place):
                if edge.target is None:
                    continue
                arriving = self.leaving[edge]
                known = self.before.get(edge.target)
                joined = dict(arriving) if known is None else _join(edge.target, known, arriving)
                if joined != known:
                    self.before[edge.target] = joined
                    waiting.append(edge.target)

    def _pass(self, place):
        state, block = dict(self.before[place]), self.flow.blocks[place]
        for insn in block.insns:
            if insn is block.last:
                self.at_end[place] = dict(state)
            step(insn, state, self.flow.program)
        for edge in self.flow.edges[place]:
            self.leaving[edge] = _on_edge(edge, block, state)
        return self.flow.edges[place]

    def constant(self, place, register):
        """The constant in a register before the place's last instruction, or None."""
        value = self.at_end[place].get(register)
        return value[1] if value and value[0] is None else None

    def rounds(self, loop):
        """Rounds of a loop of one block that counts a register up to another's value, as a
        copying loop of the compiler does; None of any other."""
        if len(loop.body) != 1:
            return None
        block = self.flow.blocks[loop.header]
        compare = next((insn for insn in reversed(block.insns[:-1]) if _sets_flags(insn)), None)
        if compare is None or compare.name != "cmp" or not block.last.text.startswith("bne"):
            return None
        state = {r: (("loop", r), 0) for r in _REGISTERS}
        for insn in block.insns[:-1]:
            if insn is compare:
                compared = [_value(operand, state) for operand in _operands(insn.text)]
            step(insn, state, self.flow.program)
        return self._count(loop, compared, state)

    def _count(self, loop, compared, after):
        """Rounds until what is compared is equal: one moves by a step a round, the other
        stays, and it is known how far apart they begin."""
        for moving, fixed in (compared, compared[::-1]):
            if moving is None or fixed is None or moving[0] is None or moving[0][0] != "loop":
                continue
            register, pace = moving[0][1], moving[1]
            if pace == 0 or after.get(register) != (moving[0], pace):
                continue
            if fixed[0] is not None and (fixed[0][0] != "loop" or fixed[1] != 0 or
                                         after.get(fixed[0][1]) != (fixed[0], 0)):
                continue
            return self._distance(loop, register, fixed, pace)
        return None

    def _distance(self, loop, register, fixed, pace):
        counts = set()
        for edge in self.flow.entering(loop.body):
            state = self.leaving[edge]
            first = state.get(register)
            end = fixed if fixed[0] is None else state.get(fixed[0][1])
            if first is None or end is None or first[0] != end[0]:
                return None
            count, rest = divmod(end[1] - first[1], pace)
            if rest or count < 1:
                return None
            counts.add(count)
        return max(counts) if counts else None
