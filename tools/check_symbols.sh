#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/check_symbols.sh

Claim: the library needs no float, no heap, no state and no helper but the few
of tools/symbols_allowed.txt.  Held on the archives of the host, Cortex-M0,
Cortex-M4 (soft float) and Cortex-M4F (hard float), each under four limits:
  - every undefined symbol is the library's own or in the allow-list;
  - no writable or initialised-at-start section has content;
  - no floating-point instruction in the hard-float disassembly (and where the
    compiler is free to use the FPU's registers, it only keeps integers there);
  - the sources compile with float, double and the heap poisoned, and with
    -mgeneral-regs-only.
HELP
}
case "${1:-}" in -h | --help) usage && exit 0 ;; "") ;; *) usage >&2 && exit 2 ;; esac

cd "$(dirname "$0")/.." || exit 1
allowed=tools/symbols_allowed.txt
arm=arm-none-eabi
for tool in gcc cmake nm objdump $arm-gcc $arm-nm $arm-objdump; do
    command -v "$tool" >/dev/null || {
        echo "check_symbols: no $tool here; run tools/setup.sh test" >&2
        exit 1
    }
done
failed=0
complain() {
    echo "check_symbols: $*" >&2
    failed=1
}

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# check_undefined ARCHIVE NM KIND...: KIND are the "where" words that apply.
check_undefined() {
    local archive="$1" nm="$2" symbol
    shift 2
    "$nm" "$archive" 2>/dev/null | awk 'NF == 3 && $2 ~ /[A-Z]/ { print $3 }' | sort -u >"$work/defined"
    "$nm" "$archive" 2>/dev/null | awk '$1 == "U" { print $2 }' | sort -u >"$work/undefined"
    [ -s "$work/defined" ] || complain "$archive: no symbols at all"
    while read -r symbol; do
        if ! awk -v symbol="$symbol" -v kinds=" $* " \
            '$1 == symbol && index(kinds, " " $2 " ") { found = 1 } END { exit !found }' "$allowed"; then
            complain "$archive: needs $symbol, which $allowed does not allow ($*)." \
                "Write the code without it (64-bit division: ocel_udiv64)."
        fi
    done < <(comm -13 "$work/defined" "$work/undefined")
    cat "$work/undefined" >>"$work/all_undefined"
}

# check_sections ARCHIVE OBJDUMP: nothing that must be written or run at start.
# .data.rel.ro is constant: the host's position-independent tables of pointers.
check_sections() {
    "$2" -h "$1" | awk '$2 ~ /^\.(data|bss|tdata|tbss|sdata|sbss|init|fini|init_array|fini_array|ctors|dtors|preinit_array)(\.|$)/ &&
        $2 !~ /^\.data\.rel\.ro/ && $3 !~ /^0+$/ { print $2, $3 }' >"$work/sections"
    if [ -s "$work/sections" ]; then
        complain "$1: has state: $(tr '\n' ' ' <"$work/sections"). Make it const or the caller's."
    fi
}

# --- The archives -------------------------------------------------------------
build() { # PRESET: the library's four variants, without a board and its tests, quietly
    local tree="build/symbols/$1"
    if ! { cmake --preset "$1" -B "$tree" -DOCEL_BOARD= -DBUILD_TESTING=OFF &&
        cmake --build "$tree" -j 2; } >"$work/log" 2>&1; then
        grep -m 5 -A 3 -E 'error|Error' "$work/log" >&2
        complain "the preset $1 does not build"
        exit 1
    fi
}
archives=0
for preset in m0 m4 m4hf; do
    build "$preset"
    kinds=(any arm)
    [ "$preset" = m0 ] && kinds+=(m0)
    for archive in build/symbols/"$preset"/lib*.a build/symbols/"$preset"/lib/lib*.a; do
        check_undefined "$archive" "$arm-nm" "${kinds[@]}"
        check_sections "$archive" "$arm-objdump"
        archives=$((archives + 1))
    done
done

# v_instructions FILE PATTERN: the mnemonics that begin with v and match PATTERN.
v_instructions() {
    $arm-objdump -d "$1" | awk -F '\t' '/^ *[0-9a-f]+:\t/ && $3 ~ /^v/ { print $3 }' |
        grep -E -- "$2" | sort | uniq -c | tr '\n' ' '
}
for archive in build/symbols/m4hf/lib*.a build/symbols/m4hf/lib/lib*.a; do
    found="$(v_instructions "$archive" .)"
    [ -n "$found" ] && complain "$archive: floating-point instructions: $found"
done

mapfile -t sources < <(grep -v '^#' lib/sources.txt)
# Without -mgeneral-regs-only the compiler may keep a 64-bit integer in a register
# of the FPU: loads, stores and moves, never arithmetic or a conversion.
cat >"$work/poison.h" <<'POISON'
#pragma GCC poison float double malloc calloc realloc alloca setjmp longjmp goto
POISON
hard="-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16"
large="-DOCEL_MAX_WIDTH=4096 -DOCEL_MAX_HEIGHT=4096 -DOCEL_MAX_CRACKS=65534"
mkdir "$work/hard" "$work/host" "$work/large" "$work/poisoned"
for source in "${sources[@]}"; do
    object="$(basename "$source" .c).o"
    cc="-std=c99 -O2 -Ilib/include -c lib/$source -o $work"
    echo "$arm-gcc $hard $cc/hard/$object"
    echo "gcc $cc/host/$object"
    echo "gcc $large $cc/large/$object"
    echo "gcc -mgeneral-regs-only -include $work/poison.h $cc/poisoned/$object"
    echo "gcc $large -mgeneral-regs-only -include $work/poison.h $cc/poisoned/large_$object"
done | xargs -P 2 -I COMMAND sh -c 'COMMAND || { echo "  in: COMMAND" >&2; exit 1; }' ||
    complain "uses floating point or the heap, or does not compile (see above)"
for object in "$work"/hard/*.o; do
    found="$(v_instructions "$object" . |
        grep -vE '^( *[0-9]+ v(ldr|str|push|pop|mov|ldmia|stmia)(\.[a-z0-9]+)?)* *$')"
    [ -n "$found" ] && complain "$(basename "$object" .o).c: floating-point arithmetic: $found"
done
for variant in host large; do
    ar rcs "$work/$variant.a" "$work/$variant"/*.o
    check_undefined "$work/$variant.a" nm any
    check_sections "$work/$variant.a" objdump
    archives=$((archives + 1))
done

while read -r symbol _; do
    grep -qx -- "$symbol" "$work/all_undefined" ||
        complain "$allowed allows $symbol, which nothing needs; take the line out"
done < <(grep -v '^#' "$allowed")

if [ "$failed" -ne 0 ]; then
    echo "check_symbols: FAILED" >&2
    exit 1
fi
echo "check_symbols: $archives archives, no float, no heap, no state; undefined only:" \
    "$(grep -v '^#' "$allowed" | awk '{ printf "%s ", $1 }')"
