# SPDX-License-Identifier: MIT
"""What the compiler calls besides the library: the stated bounds of its loops.

newlib and libgcc carry no lines, so their loops are stated here, each in the order
of its place in the code: how often it is gone through each time it is come to.
`n` is the number of bytes.  A function with another number of loops, another
release's, is refused.  tests/wcet/cases.c calls them with every length and
alignment, and holds them to these bounds.
"""

LOOPS = {
    # Whole 64 bytes, then 16, then 4; or, of less than 8 bytes, each by itself.
    ("memcpy", "m3"): ("n / 64", "3", "3", "4"),
    # Whole 16 bytes, then 4; where source or destination is not aligned, each byte.
    ("memcpy", "m0"): ("n / 16", "3", "n"),
    # Bytes up to an aligned one; whole 16, then 4, then the rest.
    ("memset", "m3"): ("3", "n / 16", "3", "3"),
    ("memset", "m0"): ("3", "n / 16", "3", "3"),
    # Eight bits of the quotient a round; at most eight come before the first.
    ("__aeabi_uidiv", "m0"): ("3",),
}

COPIES = ("memcpy", "memset")
"""Those whose time depends on n, their third argument."""


def alias(program, name):
    """The name in LOOPS of a function of the program, or None."""
    address = program.symbols[name]
    for known, _ in LOOPS:
        if program.symbols.get(known) == address:
            return known
    return None


def rounds(name, core, count):
    """Rounds of each loop for n = count."""
    stated = LOOPS[(name, "m0" if core == "m0" else "m3")]
    return [(count or 0) // int(text[4:]) if text.startswith("n /") else
            (count or 0) if text == "n" else int(text) for text in stated]
