#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/sizes.sh [--check FILE | --update FILE]

Claim: what a firmware links of the eye, from RGB565 lines by a const colour
table to the ellipse, is at most 16 KB of code (Cortex-M4, -O2), the eye's
context without its boundary pool at most 8 KB, the pool at most 8 KB, and the
stack of every public function at most 1 KB.  Prints the tables as Markdown; --check compares
them with the block <!-- sizes:begin --> of FILE, --update writes them there.
HELP
}
mode=print file=
case "${1:-}" in
-h | --help) usage && exit 0 ;;
--check | --update) mode="${1#--}" file="${2:?$(usage)}" ;;
"") ;;
*) usage >&2 && exit 2 ;;
esac

cd "$(dirname "$0")/.." || exit 1
cc=arm-none-eabi-gcc
command -v $cc >/dev/null || {
    echo "sizes: no $cc here; run tools/setup.sh test" >&2
    exit 1
}
limit_code=16384 limit_eye=8192 limit_pool=8192 limit_stack=1024
failed=0
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

mapfile -t sources < <(grep -v '^#' lib/sources.txt)
m4="-mcpu=cortex-m4 -mfloat-abi=soft -mthumb"
m0="-mcpu=cortex-m0 -mthumb"
flags="-std=c99 -ffunction-sections -fdata-sections -Ilib/include"

compile() { # NAME FLAGS...: every source into $work/NAME
    local name="$1" root="$PWD"
    shift
    mkdir "$work/$name"
    # shellcheck disable=SC2086  # flags are words
    (cd "$work/$name" && $cc $flags "$@" -I"$root/lib/include" -c "${sources[@]/#/$root/lib/}")
}
# Two compilers at a time, about as long each.
# shellcheck disable=SC2086
{
    compile m4_O2 $m4 -O2 -fstack-usage -fcallgraph-info=su,da &
    first=$!
    compile m4_Os $m4 -Os && compile m0_Os $m0 -Os || exit 1
    wait $first || exit 1
}

column() { # NAME MODULE FIELD: 1 text, 2 data, 3 bss; no MODULE: the sum
    arm-none-eabi-size "$work/$1"/${2:-*}.o | awk -v field="$3" 'NR > 1 { sum += $field } END { print sum + 0 }'
}

# The contexts, as the compiler for Cortex-M4 lays them out.
contexts=(eye labeller crack_pool colour colour_table teach detection ellipse)
{
    echo '#include <ocellus/ocellus.h>'
    for name in "${contexts[@]}"; do
        echo "extern char size_${name}[]; char size_${name}[sizeof(ocel_${name}_t)];"
    done
} >"$work/contexts.c"
# shellcheck disable=SC2086
$cc $flags $m4 -O2 -c "$work/contexts.c" -o "$work/contexts.out" || exit 1
size_of() { echo $((16#$(arm-none-eabi-nm -S "$work/contexts.out" | awk -v n="size_$1" '$4 == n { print $2 }'))); }

# What a firmware links: the code below main, with the C library's and libgcc's
# share and without the sections that nothing calls.
linked() { # NAME FLAGS CALLS...: bytes of text of a program that calls these
    local objects="$work/$1" flags_here="$2"
    shift 2
    {
        echo '#include <ocellus/ocellus.h>'
        echo 'void _start(void);'
        echo 'void (*volatile ocel_called)(void);'
        echo 'void _start(void) {'
        printf '    ocel_called = (void (*)(void))%s;\n' "$@"
        echo '}'
    } >"$work/firmware.c"
    # shellcheck disable=SC2086
    $cc -std=c99 -Ilib/include $flags_here -ffunction-sections -nostartfiles -Wl,--gc-sections \
        -specs=nano.specs "$work/firmware.c" "$objects"/*.o -o "$work/firmware.elf" || return 1
    # shellcheck disable=SC2086
    $cc -std=c99 -Ilib/include $flags_here -c "$work/firmware.c" -o "$work/firmware_main.out"
    echo $(($(arm-none-eabi-size "$work/firmware.elf" | awk 'NR > 1 { print $1 }') -
        $(arm-none-eabi-size "$work/firmware_main.out" | awk 'NR > 1 { print $1 }')))
}
linked_row() { # TITLE CALLS...: one row of the table; sets linked_O2 and linked_Os
    local title="$1"
    shift
    linked_O2="$(linked m4_O2 "$m4 -O2" "$@")" linked_Os="$(linked m4_Os "$m4 -Os" "$@")"
    echo "| $title | $linked_O2 | $linked_Os | $(linked m0_Os "$m0 -Os" "$@") |"
}
beside() { # VALUE ASKED: both cells of a row
    local mark=""
    [ "$1" -le "$2" ] || mark=", not reached"
    echo "$1$mark | $2"
}
asked=() # rows: what was asked for, beside what there is
asked_row() { # TITLE O2 OS: of the row that linked_row has just made
    asked+=("| $1 | $(beside "$linked_O2" "$2") | $(beside "$linked_Os" "$3") |")
}

# What a firmware calls after the eye.
sphere=(ocel_camera_init ocel_eye_cone ocel_sphere_of_cone)
robot=(ocel_head_forward ocel_stereo_ball ocel_tracker_init ocel_tracker_update ocel_tracker_roi
    ocel_gaze_init ocel_gaze_error ocel_gaze_update)

# Every function that a public header declares.
python3 tools/stack.py --public lib/include --limit $limit_stack "$work"/m4_O2/*.ci >"$work/stack" || failed=1

limit() { # NAME VALUE LIMIT FIX
    if [ "$2" -gt "$3" ]; then
        echo "sizes: $1 is $2 bytes, over $3. $4" >&2
        failed=1
    fi
}
eye="$(size_of eye)" pool="$(size_of crack_pool)"
limit "the eye's context without the pool" $((eye - pool)) $limit_eye "See label.h for what a column costs."
limit "the boundary pool" "$pool" $limit_pool "Lower OCEL_MAX_CRACKS in config.h."
limit ".data and .bss together" $(($(column m4_O2 "" 2) + $(column m4_O2 "" 3))) 0 "The library keeps no state."

{
    echo "Code and constants, bytes of text (\`tools/sizes.sh\`; data and bss are $(column m4_O2 "" 2) and $(column m4_O2 "" 3) everywhere):"
    echo
    echo "| module | cortex-m4 -O2 | cortex-m4 -Os | cortex-m0 -Os |"
    echo "|---|--:|--:|--:|"
    for source in "${sources[@]}"; do
        module="$(basename "$source" .c)"
        echo "| $module | $(column m4_O2 "$module" 1) | $(column m4_Os "$module" 1) | $(column m0_Os "$module" 1) |"
    done
    echo "| **all** | $(column m4_O2 "" 1) | $(column m4_Os "" 1) | $(column m0_Os "" 1) |"
    echo
    echo "What of it a firmware links, with the helpers of libgcc and the C library (\`--gc-sections\`):"
    echo
    echo "| a program that calls | cortex-m4 -O2 | cortex-m4 -Os | cortex-m0 -Os |"
    echo "|---|--:|--:|--:|"
    linked_row "the eye, on binary rows" ocel_eye_init ocel_eye_begin ocel_eye_row ocel_eye_end
    asked_row "the eye alone, on binary rows" 14336 10240
    linked_row "the eye, on RGB565 lines by a const table (limit $limit_code)" \
        ocel_eye_init ocel_eye_begin ocel_colour_table_row ocel_eye_row ocel_eye_end
    code="$linked_O2"
    linked_row "the eye, on camera lines of any format" \
        ocel_eye_init ocel_colour_compile ocel_eye_frame
    linked_row "the same, and on to the ball in its camera: cone and sphere" \
        ocel_eye_init ocel_colour_compile ocel_eye_frame "${sphere[@]}"
    linked_row "the same, and head, stereo, tracker and gaze: all there is for one method" \
        ocel_eye_init ocel_colour_compile ocel_eye_frame "${sphere[@]}" "${robot[@]}"
    asked_row "the whole library, by one method" 28672 20480
    linked_row "the labeller alone" ocel_label_begin ocel_label_row ocel_label_end
    linked_row "\`ocel_fit_boundary\` alone" ocel_fit_boundary
    linked_row "\`ocel_fit_points\` alone, every method" ocel_fit_points
    mapfile -t public < <(cut -d" " -f1 "$work/stack")
    linked_row "every public function" "${public[@]}"
    echo
    echo "Of it, beside what was asked of cortex-m4 (14 and 28 KB at -O2, 10 and 20 KB at -Os):"
    echo
    echo "| | -O2 | asked | -Os | asked |"
    echo "|---|--:|--:|--:|--:|"
    printf '%s\n' "${asked[@]}"
    echo
    echo "Memory that the caller owns, bytes on a 32-bit machine under the default limits:"
    echo
    echo "| context | bytes | limit |"
    echo "|---|--:|--:|"
    echo "| \`ocel_eye_t\` without its boundary pool | $((eye - pool)) | $limit_eye |"
    echo "| its boundary pool, \`ocel_crack_pool_t\` | $pool | $limit_pool |"
    echo "| of it, \`ocel_labeller_t\` | $(size_of labeller) | |"
    echo "| \`ocel_colour_t\` | $(size_of colour) | |"
    echo "| \`ocel_colour_table_t\`, RGB565 only, may be const | $(size_of colour_table) | 8196 |"
    echo "| \`ocel_teach_t\`, while teaching | $(size_of teach) | |"
    echo "| \`ocel_detection_t\` | $(size_of detection) | |"
    echo
    echo "Stack, bytes at most (cortex-m4 -O2, from GCC's frame sizes and call graph; limit $limit_stack):"
    echo
    echo "| function | bytes |"
    echo "|---|--:|"
    sort -k2,2nr -k1,1 "$work/stack" | awk '{ print "| `" $1 "` | " $2 " |" }'
} >"$work/sizes.md"
limit "the eye's code (cortex-m4 -O2)" "${code:-0}" $limit_code "See the tables for the largest modules."
limit "the colour table" "$(size_of colour_table)" 8196 "One bit a colour is 8 KB; 4 bytes tell its extremes."

mkdir -p build/reports
cp "$work/sizes.md" build/reports/sizes.md
case "$mode" in
print) cat "$work/sizes.md" ;;
check | update)
    python3 tools/readme_block.py "--$mode" --fix "Run tools/sizes.sh --update $file" \
        "$file" sizes "$work/sizes.md" || failed=1
    ;;
esac
if [ "$failed" -ne 0 ]; then
    echo "sizes: FAILED" >&2
    exit 1
fi
echo "sizes: code of the eye $code, eye $((eye - pool)) + pool $pool, stack $(sort -k2,2nr "$work/stack" | awk 'NR == 1 { print $2, "(" $1 ")" }')" >&2
