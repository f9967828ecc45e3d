#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/check_bits.sh [--update]

Claim: the library gives the same bits whatever compiles it.  Builds the corpus
(tests/board) with gcc and clang at -O0 to -O3 and -Os, and with Arm's sizes of
enumerations and signs of char, and compares what it says with
tests/board/corpus.expected.  --update records what gcc -O2 says there: for a
change of results that is meant, which the commit message then explains.
HELP
}
update=no
case "${1:-}" in -h | --help) usage && exit 0 ;; --update) update=yes ;; "") ;; *) usage >&2 && exit 2 ;; esac

cd "$(dirname "$0")/.." || exit 1
gcc="${GCC:-gcc}" clang="${CLANG:-clang-19}"
for tool in "$gcc" "$clang" python3; do
    command -v "$tool" >/dev/null || {
        echo "check_bits: no $tool here; run tools/setup.sh test" >&2
        exit 1
    }
done
expected=tests/board/corpus.expected
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

mapfile -t library < <(grep -v '^#' lib/sources.txt | sed 's,^,lib/,')
mapfile -t corpus < <(sed -n '/^set(corpus_sources/,/)/p' tests/board/CMakeLists.txt |
    grep -oE '[a-z_]+\.c' | sed 's,^,tests/board/,')
includes=(-Ilib/include -Ilib/src -Itests/support -Iport)

build() { # NAME COMPILER FLAGS...: prints nothing when all is well
    local name="$1"
    shift
    # timespec_get, in the host's port, is C11.
    "$@" -std=c11 "${includes[@]}" "${library[@]}" "${corpus[@]}" port/host/port.c -o "$work/$name"
}

if [ "$update" = yes ]; then
    build now "$gcc" -O2 && "$work/now" >"$work/said" || exit 1
    {
        echo "# What the corpus says (FNV-1a of every result): tools/check_bits.sh --update"
        cat "$work/said"
    } >"$expected"
    diff <(git show "HEAD:$expected" 2>/dev/null) "$expected"
    echo "check_bits: recorded; now run every preset, for the boards must say the same"
    exit 0
fi

variants=()
for level in -O0 -O1 -O2 -O3 -Os; do
    variants+=("$gcc $level" "$clang $level")
done
variants+=("$gcc -O2 -fshort-enums -funsigned-char" "$clang -O2 -fshort-enums -funsigned-char")

# One variant a line; two at a time.
one() { # VARIANT
    local name="${1// /}"
    # shellcheck disable=SC2086  # a variant is words
    build "$name" $1 &&
        python3 tests/board/compare.py "$expected" "$work/$name" >"$work/$name.log" ||
        {
            echo "check_bits: $1:" >&2
            cat "$work/$name.log" >&2
            return 1
        }
}
failed=0
pids=()
for i in "${!variants[@]}"; do
    one "${variants[$i]}" &
    pids+=($!)
    if [ $((i % 2)) -eq 1 ]; then
        for pid in "${pids[@]}"; do wait "$pid" || failed=1; done
        pids=()
    fi
done
if [ "$failed" -ne 0 ]; then
    echo "check_bits: FAILED. The same source gives other bits: undefined or unspecified" \
        "behaviour, in the library or in the corpus; or a change that is to be recorded." >&2
    exit 1
fi
echo "check_bits: ${#variants[@]} builds say $(tail -1 "$expected")"
