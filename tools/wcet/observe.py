# SPDX-License-Identifier: MIT
"""What a program executes under QEMU, by the plugin profile.c."""
import collections
import pathlib
import subprocess
import tempfile

from . import timing
from .code import Program, Refused

Counts = collections.namedtuple("Counts", "insn typ max")
"""Instructions and modelled cycles."""

Block = collections.namedtuple("Block", "begin end executions taken")
"""A piece of code that was executed as one, and how often it ended in a jump."""

Observed = collections.namedtuple("Observed", "marks calls blocks text")
"""marks: Counts at each; calls: function -> (calls, Counts of the most); text: what
the program wrote."""


def build_plugin(folder):
    """Compiles profile.c for this machine's QEMU; returns the plugin's path."""
    source = pathlib.Path(__file__).with_name("profile.c")
    plugin = pathlib.Path(folder) / "profile.so"
    if not plugin.exists() or plugin.stat().st_mtime < source.stat().st_mtime:
        subprocess.run(["gcc", "-O2", "-shared", "-fPIC", "-fvisibility=hidden",
                        "-o", plugin, source], check=True)
    return plugin


def _table(program, core, watched, mark, uncounted):
    """The lines of the plugin's table."""
    lines = []
    for name in program.all_functions():
        try:
            function = program.function(name)
        except Refused:
            continue  # data with a function's symbol
        for insn in function.insns.values():
            if name in uncounted:
                continue
            cost = timing.cost_of(insn, core)
            lines.append(f"I {insn.address} {int(insn.kind == 'call')} {cost.base[0]} "
                         f"{cost.base[1]} {cost.taken[0]} {cost.taken[1]}")
    lines += [f"F {program.symbols[name]} {name}" for name in watched if name in program.symbols]
    if mark:
        lines.append(f"M {program.symbols[mark]}")
    return "\n".join(lines) + "\n"


def _read(answer, text):
    marks, calls, blocks = [], {}, []
    for line in answer.splitlines():
        kind, *rest = line.split()
        if kind == "M":
            marks.append(Counts(*map(int, rest)))
        elif kind == "F":
            calls[rest[0]] = (int(rest[1]), Counts(*map(int, rest[2:])))
        else:
            blocks.append(Block(*map(int, rest)))
    return Observed(marks, calls, blocks, text)


def observe(elf, core, command, watched=(), mark=None, uncounted=("SysTick_Handler",)):
    """Runs `command` (QEMU up to its -kernel) on the ELF and returns what it executed, in
    cycles of `core`; `watched` are functions whose calls are told apart, `mark` one at
    whose entry the counters are noted."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        plugin = build_plugin(folder)
        table, answer = folder / "table", folder / "answer"
        table.write_text(_table(Program(elf), core, watched, mark, uncounted))
        run = subprocess.run([*command, "-plugin", f"{plugin},table={table},out={answer}",
                              "-kernel", elf], stdin=subprocess.DEVNULL, capture_output=True,
                             text=True, check=False)
        if run.returncode != 0 or not answer.exists():
            raise Refused(f"{elf} ended with {run.returncode} under QEMU:\n{run.stdout}{run.stderr}")
        return _read(answer.read_text(), run.stdout)
