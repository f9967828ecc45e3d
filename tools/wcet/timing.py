# SPDX-License-Identifier: MIT
"""Published instruction timings: the one home of the cycle tables.

Modelled cycles are these tables applied to what is executed; zero wait states,
no interrupt.  They are no measurement of a chip.  `typ` takes the middle of a
range that the manual leaves open, `max` its upper end:

  m0plus  Arm, Cortex-M0+ Technical Reference Manual (DDI 0484C), table 3-1; with
          the single-cycle multiplier.  Nothing is left open, so typ is max.
  m3      Arm, Cortex-M3 Technical Reference Manual (DDI 0337), table 3-1: a taken
          branch refills the pipeline in P = 1 to 3 cycles, long products take 3
          to 5 (4 to 7 with accumulation), a division 2 to 12, a store 1 or 2.
  m4      Arm, Cortex-M4 Technical Reference Manual (DDI 0439), table 3-1: as m3,
          products in one cycle.

Loads are never taken to overlap, and an IT instruction never to be folded: both
make a core faster than these figures.
"""
import collections

Cost = collections.namedtuple("Cost", "base taken")
"""Cycles (typ, max) of an instruction; and what it takes more when it branches."""

Core = collections.namedtuple(
    "Core", "title refill load store multiple multiply accumulate long long_accumulate divide "
            "call indirect pop_pc")
"""Each entry: (typ, max).  `refill` is what a taken branch adds to its 1; `call`
and `indirect` what BL and BX add; `multiple` what a list of registers adds to
their number; `pop_pc` what loading the PC adds to that."""

CORES = {
    "m0plus": Core("Cortex-M0+", refill=(1, 1), load=(2, 2), store=(2, 2), multiple=(1, 1),
                   multiply=(1, 1), accumulate=None, long=None, long_accumulate=None,
                   divide=None, call=(2, 2), indirect=(1, 1), pop_pc=(2, 2)),
    "m3": Core("Cortex-M3", refill=(2, 3), load=(2, 2), store=(1, 2), multiple=(1, 1),
               multiply=(1, 1), accumulate=(2, 2), long=(4, 5), long_accumulate=(5, 7),
               divide=(7, 12), call=(2, 3), indirect=(2, 3), pop_pc=(2, 3)),
    "m4": Core("Cortex-M4", refill=(2, 3), load=(2, 2), store=(1, 2), multiple=(1, 1),
               multiply=(1, 1), accumulate=(1, 1), long=(1, 1), long_accumulate=(1, 1),
               divide=(7, 12), call=(2, 3), indirect=(2, 3), pop_pc=(2, 3)),
}
"""The tables; the keys are the names that the tools take."""

OF_COMPILER = {"m0": "m0plus", "m3": "m3", "m4": "m4"}
"""The core whose table is applied to code that was compiled for -mcpu=cortex-..."""

_LOADS = {"ldr", "ldrb", "ldrh", "ldrsb", "ldrsh", "ldrt"}
_STORES = {"str", "strb", "strh"}
_LISTS = {"ldm", "stm", "push", "pop", "ldmdb", "stmdb", "ldmia", "stmia", "ldrd", "strd"}
_MULTIPLIES = {"mul", "smulbb", "smulbt", "smultb", "smultt", "smulwb", "smulwt", "smmul",
               "smuad", "smusd", "smmulr", "smuadx", "smusdx"}
_ACCUMULATES = {"mla", "mls", "smlabb", "smlabt", "smlatb", "smlatt", "smlawb", "smlawt",
                "smmla", "smmls", "smlad", "smlsd", "smmlar", "smmlsr", "usada8", "usad8"}
_LONG = {"smull", "umull"}
_LONG_ACCUMULATES = {"smlal", "umlal", "umaal", "smlalbb", "smlalbt", "smlaltb", "smlaltt",
                     "smlald", "smlsld"}
_SINGLE = {
    "adc", "add", "addw", "adr", "and", "asr", "bfc", "bfi", "bic", "clz", "cmn", "cmp", "eor",
    "it", "lsl", "lsr", "mov", "movs", "movt", "movw", "mvn", "neg", "nop", "orn", "orr", "pkhbt",
    "pkhtb", "pld", "rbit", "rev", "rev16", "revsh", "ror", "rrx", "rsb", "sbc", "sbfx", "sel", "ssat",
    "sub", "subw", "sxtab", "sxtah", "sxtb", "sxtb16", "sxth", "teq", "tst", "uadd8", "ubfx",
    "uqsub8", "usat", "usub8", "uxtab", "uxtah", "uxtb", "uxtb16", "uxth", "uadd16", "usub16",
    "sadd16", "ssub16", "uhadd8", "uqadd8", "qadd", "qsub"}
_SYSTEM = {"mrs", "msr", "cpsid", "cpsie", "dmb", "dsb", "isb", "bkpt", "svc", "udf", "wfi"}


class Unknown(Exception):
    """An instruction that the tables do not have."""


def _plus(left, right):
    return (left[0] + right[0], left[1] + right[1])


def _straight(name, registers, core):
    """Cycles (typ, max) of an instruction that does not branch."""
    if name in _SINGLE:
        return (1, 1)
    for names, cycles in ((_LOADS, core.load), (_STORES, core.store),
                          (_MULTIPLIES, core.multiply), (_ACCUMULATES, core.accumulate),
                          (_LONG, core.long), (_LONG_ACCUMULATES, core.long_accumulate),
                          ({"sdiv", "udiv"}, core.divide)):
        if name in names:
            if cycles is None:
                raise Unknown(f"{name} on {core.title}")
            return cycles
    if name in _LISTS:
        return _plus(core.multiple, (registers, registers))
    if name in _SYSTEM:
        return (3, 3)
    raise Unknown(f"{name} on {core.title}")


def cost_of(insn, core_name):
    """Cost of an instruction of wcet.code on a core."""
    core = CORES[core_name]
    if insn.kind == "call":
        extra = core.indirect if insn.name == "blx" else core.call
        return Cost(_plus((1, 1), extra), (0, 0))
    if insn.kind == "jump" and insn.name in ("b", "bx", "cbz", "cbnz", "mov", "add"):
        extra = core.indirect if insn.name == "bx" else core.refill
    elif insn.kind == "jump":  # a load of the PC
        loaded = core.load if insn.name == "ldr" else _plus(core.multiple, (insn.registers,) * 2)
        return _jump_cost(insn, loaded, core.pop_pc)
    else:
        return Cost(_straight(insn.name, insn.registers, core), (0, 0))
    return _jump_cost(insn, (1, 1), extra)


def _jump_cost(insn, base, extra):
    """A jump that is always taken carries its refill in its base."""
    if insn.conditional:
        return Cost(base, extra)
    return Cost(_plus(base, extra), (0, 0))
