#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Tests of tools/wcet.py on small functions (cases.c), for M0 and M4 at -Os, -O2, -O3.

The bound of each must be what its worst input takes, or no more than a stated ratio
over it; one whose comment is wrong must be found out; memcpy, memset and the division
of M0 must keep to their stated bounds at every length, alignment and operand; and what
cannot be bounded (refused/) must be refused, by name and place.
"""
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "tools"))

from wcet import boards, build, observe, timing  # noqa: E402
from wcet.bounds import Annotations, Matcher  # noqa: E402
from wcet.code import Program, Refused  # noqa: E402
from wcet.ipet import Analysis  # noqa: E402
from wcet.lines import Lines  # noqa: E402

RATIOS = {                  # bound over what the worst input takes, at most
    "straight": 1.0, "branch": 1.0, "loop": 1.0, "nested": 1.0, "calls": 1.0, "rare": 1.0,
    # A round more: the loop's last look is not told from a round.
    "early_exit": 1.07, "bits": 1.04,
    # At -O3 its inner loop is unrolled into the outer one, and any round counts as one of
    # either.
    "triangle": 6.5,
    # Its loops are unrolled at -O3, and what is left no longer adds up to one bound.
    "shared": 1.9,
    "through": 1.02,
    "counter": 1.1,
    "divide": 1.3,
}
COPIED, SHIFTS = 70, 16     # of cases.h, cases_main.c
REFUSED = {                 # file -> what the message must have in it
    "loop": ("refused: at 0x", "loop.c:8", "no `bound:` comment"),
    "recursion": ("recursion: refused -> refused",),
    "pointer": ("refused: a call through a pointer",),
    "table": ("refused: a jump to a computed place",),
    "length": ("memcpy at 0x", "length.c:9", "number of bytes"),
}


def analyse(config, elf, paths, folder):
    annotations = Annotations(paths)
    annotations.values = build.evaluate(config, annotations.expressions(), folder / "values")
    annotations.check_values()
    return Analysis(Program(elf), Matcher(annotations, Lines(elf)), config.core)


def check_copies(analysis, marks):
    """Spans between marks: of memcpy and memset in turn, each with what calls it."""
    spans = [b.insn - a.insn for a, b in zip(marks, marks[1:])]
    spans = [span for i, span in enumerate(spans) if i % 3 != 2]   # not from copy to copy
    around = min(spans)     # n = 0: the call and the mark, and hardly more
    worst = 0.0
    for i, span in enumerate(spans):
        name, n = ("memcpy", "memset")[i % 2], i // 2 // SHIFTS
        bound = analysis.bound(name, n)[0]
        if span > bound + around:
            yield f"{name} of {n} bytes: {span} instructions, over {bound} + {around}"
        worst = max(worst, bound / max(1, span - around + 1)) if n > 32 else worst
    if len(spans) != 2 * SHIFTS * (COPIED + 1):
        yield f"{len(spans)} copies: not what cases_main.c makes"


def check_cases(config, folder):
    """What is wrong, as texts."""
    include = ["-I", str(HERE), "-fno-builtin"]
    objects = build.compile_all(config, [HERE / "cases.c", HERE / "cases_main.c"], folder / "o",
                                include)
    elf = build.link_program(config, objects, folder, folder / "cases.elf")
    names = [f"case_{name}" for name in (*RATIOS, "wrong")]
    seen = observe.observe(elf, timing.OF_COMPILER[config.core],
                           [*boards.QEMU, "-M", boards.of_core(config.core).machine],
                           watched=names, mark="case_mark")
    analysis = analyse(config, elf, [HERE / "cases.c"], folder)
    for name in names:
        bound, most = analysis.bound(name), tuple(seen.calls[name][1])
        over = any(b < m for b, m in zip(bound, most))
        if name == "case_wrong":
            if not over:
                yield f"{name}: its comment is wrong, and nothing was over {bound}"
        elif over:
            yield f"{name}: {most} was executed, over {bound}"
        elif bound[0] > RATIOS[name.removeprefix("case_")] * most[0]:
            yield f"{name}: bound {bound[0]}, and its worst input takes {most[0]} instructions"
    yield from check_copies(analysis, seen.marks)


def check_refused(config, folder):
    for name, words in REFUSED.items():
        path = HERE / "refused" / f"{name}.c"
        objects = build.compile_all(config, [path], folder / "refused", ["-std=gnu99"])
        elf = build.link_library(config, objects, folder / "refused" / f"{name}.elf")
        try:
            bound = analyse(config, elf, [path], folder).bound("refused")
            yield f"{path.name}: bounded, {bound}"
        except Refused as error:
            missing = [word for word in words if word not in str(error)]
            if missing:
                yield f"{path.name}: the message lacks {missing}: {error}"


def main():
    failed = 0
    for core in ("m0", "m4"):
        for level in ("-Os", "-O2", "-O3"):
            config = build.Config(core, level, 320, 240, 2048)
            with tempfile.TemporaryDirectory() as folder:
                folder = pathlib.Path(folder)
                faults = list(check_cases(config, folder))
                if level == "-O2":
                    faults += check_refused(config, folder)
            for fault in faults:
                print(f"check_cases: {core} {level}: {fault}", file=sys.stderr)
            failed += len(faults)
    print(f"check_cases: {failed} faults" if failed else "check_cases: bounds as they should be")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
