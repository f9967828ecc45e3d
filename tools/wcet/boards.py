# SPDX-License-Identifier: MIT
"""The emulated boards, as port/boards.cmake has them."""
import collections
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]

Board = collections.namedtuple("Board", "machine flags systick_hz values")
"""values: what fills in the linker template."""

QEMU = ["qemu-system-arm", "-display", "none", "-monitor", "none", "-serial", "null",
        "-chardev", "stdio,id=text", "-semihosting-config",
        "enable=on,target=native,chardev=text"]

_FLAGS = {"m0": ["-mcpu=cortex-m0"], "m3": ["-mcpu=cortex-m3"],
          "m4": ["-mcpu=cortex-m4", "-mfloat-abi=soft"]}
_MACHINES = {"m0": "mps2-an385", "m3": "mps2-an385", "m4": "mps2-an386"}
_FIELDS = ("code_origin", "code_size", "ram_origin", "ram_size", "stack_size", "systick_hz")


def of_core(core):
    """The board on which code for a core (m0, m3, m4) is run."""
    machine = _MACHINES[core]
    text = (ROOT / "port" / "boards.cmake").read_text()
    line = re.search(rf"^ocel_board\({re.escape(machine)}\s+([^)]*)\)", text, re.MULTILINE)
    values = dict(zip(_FIELDS, line.group(1).split()))
    return Board(machine, _FLAGS[core] + ["-mthumb"], values["systick_hz"], values)
