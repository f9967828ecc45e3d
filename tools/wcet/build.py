# SPDX-License-Identifier: MIT
"""Builds what is bounded: the library for a core, a size and an optimisation."""
import collections
import concurrent.futures
import pathlib
import re
import subprocess

from .boards import ROOT, of_core
from .code import Refused

CC = "arm-none-eabi-gcc"

FLAGS = ["-std=c99", "-ffunction-sections", "-fdata-sections",
         # A jump table would be a jump to a computed place.
         "-fno-jump-tables",
         # Lines and inlined calls; GCC makes the same code with and without.
         "-g1", "-gdwarf-4", "-gno-statement-frontiers"]
"""Beside those that the board's presets have."""

Config = collections.namedtuple("Config", "core level width height cracks")
"""core: m0, m3 or m4; level: -O2 and the like; the library's limits."""


def defines(config):
    return [f"-DOCEL_MAX_WIDTH={config.width}", f"-DOCEL_MAX_HEIGHT={config.height}",
            f"-DOCEL_MAX_CRACKS={config.cracks}"]


def sources():
    """The library's files."""
    listed = (ROOT / "lib" / "sources.txt").read_text().split("\n")
    return [ROOT / "lib" / line for line in listed if line and not line.startswith("#")]


def _run(command):
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise Refused(f"{' '.join(map(str, command[:1]))} failed:\n{run.stderr}")
    return run.stdout


def compile_all(config, paths, folder, extra=()):
    """Objects of C files, two compilers at a time."""
    flags = [*of_core(config.core).flags, config.level, *FLAGS, *defines(config),
             "-I", ROOT / "lib" / "include", *extra]
    folder.mkdir(parents=True, exist_ok=True)

    def compile_one(path):
        out = folder / (path.parent.name + "_" + path.stem + ".o")
        _run([CC, *flags, "-c", path, "-o", out])
        return out

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return list(pool.map(compile_one, paths))


def link_library(config, objects, out):
    """An ELF of all the library with what it calls of libgcc and the C library; it is
    there to be read, not to run."""
    _run([CC, *of_core(config.core).flags, "-nostartfiles", "-Wl,-e,0", "--specs=nosys.specs",
          *objects, "-o", out])
    return out


def linker_script(board, folder):
    text = (ROOT / "port" / "arm" / "board.ld.in").read_text()
    for name, value in board.values.items():
        text = text.replace(f"@{name}@", value)
    path = folder / f"{board.machine}.ld"
    path.write_text(text)
    return path


def link_program(config, objects, folder, out):
    """A program that runs on the core's board, without stdio."""
    board = of_core(config.core)
    port = [ROOT / "port" / "arm" / "port.c", ROOT / "port" / "arm" / "startup.c"]
    objects = objects + compile_all(config, port, folder / "port", [
        "-I", ROOT / "port", f"-DOCEL_PORT_SYSTICK_HZ={board.systick_hz}U", "-DOCEL_PORT_STDIO=0"])
    _run([CC, *board.flags, "-nostartfiles", "-Wl,--gc-sections", "--specs=nosys.specs",
          "-T", linker_script(board, folder), *objects, "-o", out])
    return out


def public_functions():
    """What the public headers declare."""
    text = _run([CC, "-E", "-P", "-I", ROOT / "lib" / "include",
                 ROOT / "lib" / "include" / "ocellus" / "ocellus.h"])
    return sorted(set(re.findall(r"\b(ocel_[a-z0-9_]+)\(", text)))


def _wrapper(path, expressions):
    """A C file whose assembly says what the expressions come to at `path`, one a line."""
    lines = ["#include <ocellus/ocellus.h>", f'#include "{path}"',
             "void ocel_wcet_values(void);", "void ocel_wcet_values(void) {"]
    lines += [f'    __asm__ volatile("@VALUE {i} %c0" : : "i"((long)({expression})));'
              for i, expression in enumerate(expressions)]
    return "\n".join([*lines, "}"]) + "\n"


def _evaluate_at(config, path, expressions, file):
    """expression -> value.  What is not declared under these limits, in lines that the
    preprocessor leaves out, has none."""
    command = [CC, *of_core(config.core).flags, "-O1", "-std=gnu99", *defines(config),
               "-I", ROOT / "lib" / "include", "-S", file, "-o", "-"]
    file.write_text(_wrapper(path, expressions))
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    bad = {int(line) - 5 for line in re.findall(rf"{re.escape(file.name)}:(\d+):\d+: error: "
                                                "'[A-Z_0-9]+' undeclared", run.stderr)}
    if bad:
        return _evaluate_at(config, path, [e for i, e in enumerate(expressions) if i not in bad],
                            file)
    if run.returncode != 0:
        raise Refused(f"the bounds of {path} do not compile:\n{run.stderr}")
    return {expressions[int(number)]: int(value)
            for number, value in re.findall(r"@VALUE (\d+) (-?\d+)", run.stdout)}


def evaluate(config, wanted, folder):
    """wanted: path -> expressions; returns path -> expression -> its value there, under
    the limits of the build, by the compiler that makes it."""
    folder.mkdir(parents=True, exist_ok=True)

    def evaluate_one(item):
        path, expressions = item
        values = {e: int(e.rstrip("U")) for e in expressions if re.fullmatch(r"\d+U?", e)}
        rest = sorted({e for e in expressions if e not in values})
        if rest:
            file = folder / (path.parent.name + "_" + path.name.replace(".", "_") + ".c")
            values.update(_evaluate_at(config, path, rest, file))
        return path, values

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return dict(pool.map(evaluate_one, wanted.items()))
