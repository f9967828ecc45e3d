# SPDX-License-Identifier: MIT
"""Machine code of an ELF for Cortex-M: functions and their instructions.

Thumb code and literal pools are told apart by the mapping symbols $t and $d
(Arm, ELF for the Arm Architecture, IHI 0044).
"""
import bisect
import collections

import capstone
from capstone import arm
from elftools.elf.elffile import ELFFile

Insn = collections.namedtuple(
    "Insn", "address size name text kind conditional target registers")
"""kind: plain, call, jump (target None: to a place that the code computes, or where
the caller said), trap (from where nothing goes on).  `registers` is how many a list
loads or stores."""

Function = collections.namedtuple("Function", "name address size insns")


class Refused(Exception):
    """What cannot be bounded, and where."""


def is_return(insn):
    """True of a jump to where the caller said: bx lr, pop {.., pc} and the like."""
    if insn.kind != "jump" or insn.target is not None:
        return False
    return insn.text in ("bx lr", "mov pc, lr") or insn.name in ("pop", "ldm") or \
        insn.text.startswith("ldr pc, [sp]")


def _registers(raw):
    if raw.mnemonic.startswith(("ldrd", "strd")):
        return 2
    count = sum(1 for op in raw.operands if op.type == arm.ARM_OP_REG)
    return count - 1 if raw.mnemonic.startswith(("ldm", "stm")) else count


def _base_name(raw):
    """The mnemonic without condition, flags and width."""
    return capstone_names[raw.id]


capstone_names = {getattr(arm, key): key[8:].lower() for key in dir(arm)
                  if key.startswith("ARM_INS_") and key != "ARM_INS_ENDING"}


def _writes_pc(raw):
    return any(op.type == arm.ARM_OP_REG and op.reg == arm.ARM_REG_PC and
               op.access & capstone.CS_AC_WRITE for op in raw.operands)


def _is_pc_load(raw, name):
    registers = [op.reg for op in raw.operands if op.type == arm.ARM_OP_REG]
    if name in ("pop", "ldm"):
        return arm.ARM_REG_PC in registers
    return name in ("ldr", "mov", "add") and bool(registers) and registers[0] == arm.ARM_REG_PC


def _insn(raw):
    name = _base_name(raw)
    immediate = [op.imm for op in raw.operands if op.type == arm.ARM_OP_IMM]
    conditional = raw.cc not in (arm.ARM_CC_AL, arm.ARM_CC_INVALID)
    kind, target = "plain", None
    if name in ("bl", "blx"):
        kind = "call"
        target = immediate[0] & ~1 if immediate else None
    elif name in ("b", "cbz", "cbnz"):
        kind, target = "jump", immediate[0] & ~1
        conditional = conditional or name != "b"
    elif name in ("bx", "tbb", "tbh") or _is_pc_load(raw, name):
        kind = "jump"
    elif name == "udf":
        kind = "trap"
    text = f"{raw.mnemonic} {raw.op_str}".replace(".w", "").strip()
    if conditional and kind == "jump" and name not in ("b", "cbz", "cbnz"):
        text = text.replace(raw.mnemonic, name, 1)
    return Insn(raw.address, raw.size, name, text, kind, conditional, target, _registers(raw))


class Program:
    """The code of an ELF file."""

    def __init__(self, path):
        self.path = path
        with open(path, "rb") as file:
            elf = ELFFile(file)
            self._segments = [(s["sh_addr"], s.data()) for s in elf.iter_sections()
                              if s["sh_flags"] & 2 and s["sh_type"] == "SHT_PROGBITS"]
            self._read_symbols(elf)
        self._decoder = capstone.Cs(capstone.CS_ARCH_ARM,
                                    capstone.CS_MODE_THUMB | capstone.CS_MODE_MCLASS)
        self._decoder.detail = True
        self._functions = {}

    def _read_symbols(self, elf):
        self._sizes, mapping, found = {}, [], {}
        code = {i for i, section in enumerate(elf.iter_sections()) if section["sh_flags"] & 4}
        for symbol in elf.get_section_by_name(".symtab").iter_symbols():
            kind, value = symbol["st_info"]["type"], symbol["st_value"]
            if symbol["st_shndx"] not in code:
                continue
            if symbol.name[:2] in ("$t", "$d", "$a"):
                mapping.append((value, symbol.name[1]))
            elif kind == "STT_FUNC":
                address = value & ~1
                self._sizes[address] = max(symbol["st_size"], self._sizes.get(address, 0))
                found.setdefault(address, set()).add(
                    (symbol["st_info"]["bind"] != "STB_GLOBAL", symbol.name))
        self._mapping = sorted(mapping)
        self._starts = sorted(found)
        self._name(found)

    def _name(self, found):
        """Each address has one name here, global ones first; a static function whose name
        another one has too gets its address behind it."""
        self.symbols = {}       # every name -> address
        self.names = {}         # address -> its name
        for address, symbols in sorted(found.items(), key=lambda item: (min(item[1]), item[0])):
            local, name = min(symbols)
            if name in self.symbols:
                name = f"{name}.{address:x}"
            self.names[address] = name
            self.symbols[name] = address
            self.symbols.update({other: address for is_local, other in symbols
                                 if not is_local and other not in self.symbols})

    def size(self, address):
        """Bytes of a function; without a stated size, up to the next one."""
        if self._sizes[address]:
            return self._sizes[address]
        after = bisect.bisect_right(self._starts, address)
        return (self._starts[after] if after < len(self._starts) else address) - address

    def bytes_at(self, address, size):
        for start, data in self._segments:
            if start <= address < start + len(data):
                return data[address - start:address - start + size]
        raise Refused(f"no code at {address:#x}")

    def word_at(self, address):
        return int.from_bytes(self.bytes_at(address, 4), "little")

    def function_of(self, address):
        """Name of the function that holds an address, or None."""
        at = bisect.bisect_right(self._starts, address) - 1
        if at < 0 or address >= self._starts[at] + max(self.size(self._starts[at]), 2):
            return None
        return self.names[self._starts[at]]

    def _code_ranges(self, begin, end):
        """The pieces of [begin, end) that are instructions."""
        at = bisect.bisect_right(self._mapping, (begin, "z")) - 1
        pieces, start, mode = [], begin, self._mapping[at][1] if at >= 0 else "t"
        for address, kind in self._mapping[at + 1:]:
            if address >= end:
                break
            if kind != mode:
                if mode == "t" and start < address:
                    pieces.append((start, address))
                start, mode = address, kind
        if mode == "t" and start < end:
            pieces.append((start, end))
        return pieces

    def function(self, name):
        """Function by name, decoded when first asked for."""
        if name not in self._functions:
            address = self.symbols[name]
            insns = collections.OrderedDict()
            for begin, end in self._code_ranges(address, address + self.size(address)):
                reached = begin
                for raw in self._decoder.disasm(self.bytes_at(begin, end - begin), begin):
                    insns[raw.address] = _insn(raw)
                    reached = raw.address + raw.size
                if reached < end:
                    raise Refused(f"{name}: no instruction at {reached:#x}")
            self._functions[name] = Function(name, address, self.size(address), insns)
        return self._functions[name]

    def all_functions(self):
        return sorted(set(self.names.values()))
