# SPDX-License-Identifier: MIT
"""What a register is known to hold: constants carried through a function.

For one question only: how many bytes a call of memcpy or memset is for.
"""
import re

_REGISTER = re.compile(r"^(r\d+|sb|sl|fp|ip|lr|sp|pc)$")
_IMMEDIATE = re.compile(r"^#(-?(?:0x[0-9a-f]+|\d+))$")
_LITERAL = re.compile(r"^\[pc, #((?:0x[0-9a-f]+|\d+))\]$")
_CALL_CLOBBERS = ("r0", "r1", "r2", "r3", "ip", "lr")
_READS_ONLY = {"cmp", "cmn", "tst", "teq", "str", "strb", "strh", "strd", "push", "stm", "b", "bx",
               "cbz", "cbnz", "it", "nop", "udf"}
_BINARY = {"add": lambda a, b: a + b, "addw": lambda a, b: a + b, "sub": lambda a, b: a - b,
           "subw": lambda a, b: a - b, "lsl": lambda a, b: a << b, "lsr": lambda a, b: a >> b,
           "orr": lambda a, b: a | b, "and": lambda a, b: a & b, "mul": lambda a, b: a * b}


def _operands(text):
    parts = text.split(" ", 1)
    if len(parts) == 1:
        return []
    return [part.strip() for part in re.split(r",\s*(?![^\[{]*[\]}])", parts[1])]


def _value(operand, state):
    immediate = _IMMEDIATE.match(operand)
    if immediate:
        return int(immediate.group(1), 0)
    return state.get(operand)


def _result(insn, operands, state, program):
    """What the first operand holds after the instruction, or None."""
    literal = _LITERAL.match(operands[1]) if len(operands) == 2 else None
    if insn.name == "ldr" and literal:
        return program.word_at((insn.address + 4 & ~3) + int(literal.group(1), 0))
    if insn.name in ("mov", "movs", "movw") and len(operands) == 2:
        return _value(operands[1], state)
    if insn.name in _BINARY and len(operands) in (2, 3):
        left, right = (_value(op, state) for op in (operands[-2], operands[-1]))
        if left is not None and right is not None:
            return _BINARY[insn.name](left, right) & 0xFFFFFFFF
    return None


def _step(insn, state, program):
    """The registers' constants after an instruction."""
    operands = _operands(insn.text)
    if insn.kind == "call":
        for register in _CALL_CLOBBERS:
            state.pop(register, None)
        return
    for group in operands:
        if group.startswith("{") and insn.name in ("pop", "ldm"):
            for register in re.findall(r"\w+", group):
                state.pop(register, None)
        elif group.endswith("!"):
            state.pop(group.strip("!"), None)
    if insn.name in _READS_ONLY or not operands:
        return
    value = None if insn.conditional else _result(insn, operands, state, program)
    count = 2 if insn.name in ("ldrd", "umull", "smull", "umlal", "smlal", "umaal") else 1
    for register in operands[:count]:
        state.pop(register, None)
    if value is not None and _REGISTER.match(operands[0]):
        state[operands[0]] = value
    if len(operands) == 3 and operands[1].startswith("[") and operands[2].startswith("#"):
        state.pop(operands[1].strip("[]"), None)     # [rn], #step


def at_calls(flow):
    """place -> register -> constant, at the end of each block before its last instruction
    has been executed."""
    begins = {flow.entry: {}}
    ends = {}
    waiting = [flow.entry]
    while waiting:
        place = waiting.pop()
        state = dict(begins[place])
        block = flow.blocks[place]
        for insn in block.insns:
            if insn is block.last:
                ends[place] = dict(state)
            _step(insn, state, flow.program)
        for target in flow.successors(place):
            known = begins.get(target)
            joined = dict(state) if known is None else {
                register: value for register, value in known.items()
                if state.get(register) == value}
            if joined != known:
                begins[target] = joined
                waiting.append(target)
    return ends
