#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/check_warnings.sh [SOURCE...]

Claim: the library compiles without one warning, as pedantic C99, with gcc
(its static analyser on) and with clang, under the default, the largest and the
smallest limits; each public header compiles alone as C99 and as C++17.  With
SOURCE (as lib/sources.txt lists it: src/base/status.c) only those, and every header.
HELP
}
case "${1:-}" in -h | --help) usage && exit 0 ;; -*) usage >&2 && exit 2 ;; esac

cd "$(dirname "$0")/.." || exit 1
gcc="${GCC:-gcc}" gxx="${GXX:-g++}" clang="${CLANG:-clang-19}"
for tool in "$gcc" "$gxx" "$clang"; do
    command -v "$tool" >/dev/null || {
        echo "check_warnings: no $tool here; run tools/setup.sh test" >&2
        exit 1
    }
done

common=(-std=c99 -pedantic -O2 -Wall -Wextra -Wconversion -Wsign-conversion -Wdouble-promotion
    -Wvla -Wundef -Wshadow -Wcast-qual -Wmissing-prototypes -Wstrict-prototypes -Walloca
    -Wswitch-default -Werror -Ilib/include -c -o /dev/null)
only_gcc=(-Wcast-align=strict -Wlogical-op -fanalyzer)
only_clang=(-Wcast-align)
limits=("" "-DOCEL_MAX_WIDTH=4096 -DOCEL_MAX_HEIGHT=4096 -DOCEL_MAX_CRACKS=65534"
    "-DOCEL_MAX_WIDTH=8 -DOCEL_MAX_HEIGHT=1 -DOCEL_MAX_CRACKS=64")

sources=("$@")
[ "$#" -gt 0 ] || mapfile -t sources < <(grep -v '^#' lib/sources.txt)

# A header is compiled by including it in a file with one declaration.
unit="$(mktemp)"
trap 'rm -f "$unit"' EXIT
echo 'extern int ocel_nothing;' >"$unit"

# One command a line; xargs runs two at a time.
commands() {
    local source header limit
    for source in "${sources[@]}"; do
        for limit in "${limits[@]}"; do
            echo "$gcc ${common[*]} ${only_gcc[*]} $limit lib/$source"
            echo "$clang ${common[*]} ${only_clang[*]} $limit lib/$source"
        done
    done
    for header in lib/include/ocellus/*.h; do
        echo "$gcc ${common[*]} ${only_gcc[*]} -x c -include $PWD/$header $unit"
        echo "$gxx -std=c++17 -pedantic -Wall -Wextra -Werror -Ilib/include -c -o /dev/null" \
            "-x c++ -include $PWD/$header $unit"
    done
}

if commands | xargs -P 2 -I COMMAND sh -c 'COMMAND || { echo "  in: COMMAND" >&2; exit 1; }'; then
    echo "check_warnings: $(commands | wc -l) compilations of lib/, no warning"
else
    echo "check_warnings: FAILED. Mend the code above; do not silence the warning." >&2
    exit 1
fi
