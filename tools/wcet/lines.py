# SPDX-License-Identifier: MIT
"""Which source line an instruction is of, and through which inlined calls."""
import bisect
import collections
import pathlib

from elftools.elf.elffile import ELFFile

Frame = collections.namedtuple("Frame", "instance path line name")
"""A line in a function or, by `instance`, in one inlined copy of the function `name`."""

_Inlined = collections.namedtuple("_Inlined", "instance ranges depth call_path call_line name")


def _name_of(die):
    """Name of what was inlined."""
    while "DW_AT_name" not in die.attributes:
        if "DW_AT_abstract_origin" not in die.attributes:
            return ""
        die = die.get_DIE_from_attribute("DW_AT_abstract_origin")
    return die.attributes["DW_AT_name"].value.decode()


def _ranges_of(die, unit, unit_base, range_lists):
    low = die.attributes.get("DW_AT_low_pc")
    high = die.attributes.get("DW_AT_high_pc")
    if low and high:
        end = high.value if high.form == "DW_FORM_addr" else low.value + high.value
        return [(low.value, end)]
    where = die.attributes.get("DW_AT_ranges")
    if not where:
        return []
    base, ranges = unit_base, []
    for entry in range_lists.get_range_list_at_offset(where.value, unit):
        if hasattr(entry, "base_address"):
            base = entry.base_address
        else:
            ranges.append((base + entry.begin_offset, base + entry.end_offset))
    return ranges


class Lines:
    """Line table and inlined calls of an ELF file with DWARF 4."""

    def __init__(self, path):
        self._rows = []         # (address, path, line), the last of an address wins
        self._inlined = collections.defaultdict(list)   # function's address -> _Inlined
        with open(path, "rb") as file:
            dwarf = ELFFile(file).get_dwarf_info()
            for unit in dwarf.iter_CUs():
                if unit["version"] == 4:    # others are of the C library
                    self._read_unit(dwarf, unit)
        self._rows.sort(key=lambda row: row[0])
        self._starts = [row[0] for row in self._rows]

    def _read_unit(self, dwarf, unit):
        top = unit.get_top_DIE()
        program = dwarf.line_program_for_CU(unit)
        if program is None:
            return
        paths = _paths(top, program)
        previous = None
        for entry in program.get_entries():
            state = entry.state
            if state is None:
                continue
            if state.end_sequence:
                self._rows.append((state.address, None, 0))
                previous = None
            elif previous is not None and previous[0] == state.address:
                self._rows[-1] = previous = (state.address, paths.get(state.file), state.line)
            else:
                previous = (state.address, paths.get(state.file), state.line)
                self._rows.append(previous)
        low = top.attributes.get("DW_AT_low_pc")
        self._read_functions(top, paths, low.value if low else 0, dwarf.range_lists())

    def _read_functions(self, top, paths, base, range_lists):
        for die in top.iter_children():
            if die.tag != "DW_TAG_subprogram":
                continue
            ranges = _ranges_of(die, die.cu, base, range_lists)
            if ranges:
                self._read_inlined(die, ranges[0][0] & ~1, 1, paths, base, range_lists)

    def _read_inlined(self, die, function, depth, paths, base, range_lists):
        for child in die.iter_children():
            if child.tag == "DW_TAG_inlined_subroutine":
                call_file = child.attributes["DW_AT_call_file"].value
                call_line = child.attributes["DW_AT_call_line"].value
                self._inlined[function].append(_Inlined(
                    child.offset, _ranges_of(child, child.cu, base, range_lists), depth,
                    paths.get(call_file), call_line, _name_of(child)))
                self._read_inlined(child, function, depth + 1, paths, base, range_lists)
            elif child.tag == "DW_TAG_lexical_block":
                self._read_inlined(child, function, depth, paths, base, range_lists)

    def place(self, address):
        """(path, line) of an instruction; (None, 0) without."""
        at = bisect.bisect_right(self._starts, address) - 1
        return self._rows[at][1:] if at >= 0 else (None, 0)

    def frames(self, function, address):
        """Frames of an instruction of the function at `function`, the outermost first."""
        path, line = self.place(address)
        calls = sorted((inlined for inlined in self._inlined.get(function, ())
                        if any(a <= address < b for a, b in inlined.ranges)),
                       key=lambda inlined: inlined.depth)
        copies = [(function, "")] + [(inlined.instance, inlined.name) for inlined in calls]
        places = [(inlined.call_path, inlined.call_line) for inlined in calls] + [(path, line)]
        return [Frame(instance, *place, name) for (instance, name), place in zip(copies, places)]


def _paths(top, program):
    """file number -> resolved path, of DWARF 4."""
    folder = top.attributes.get("DW_AT_comp_dir")
    base = pathlib.Path(folder.value.decode() if folder else ".")
    folders = [base] + [base / name.decode() for name in program["include_directory"]]
    return {number: (folders[entry.dir_index] / entry.name.decode()).resolve()
            for number, entry in enumerate(program["file_entry"], 1)}
