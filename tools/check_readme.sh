#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/check_readme.sh

Claim: the program in the README compiles without a warning, runs and prints
what the README says.  The program is the ```c block that follows the line
<!-- example:program -->; the output is the block that follows the line
<!-- example:output -->.  The program has at most 20 lines of code.
HELP
}
case "${1:-}" in -h | --help) usage && exit 0 ;; "") ;; *) usage >&2 && exit 2 ;; esac

cd "$(dirname "$0")/.." || exit 1
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
fail() {
    echo "check_readme: FAILED: $*" >&2
    exit 1
}
[ -f README.md ] || fail "no README.md"

block() { # MARKER: the lines of the first fenced block after it
    awk -v marker="<!-- example:$1 -->" '
        $0 == marker { armed = 1; next }
        armed && /^```/ { if (inside) exit; inside = 1; next }
        inside { print }' README.md
}
block program >"$work/example.c"
block output >"$work/expected"
[ -s "$work/example.c" ] || fail "no \`\`\`c block after <!-- example:program -->"
[ -s "$work/expected" ] || fail "no block after <!-- example:output -->"
lines="$(grep -cvE '^[[:space:]]*(/\*.*\*/|//.*)?[[:space:]]*$' "$work/example.c")"
[ "$lines" -le 20 ] || fail "the program has $lines lines of code, over 20"

mapfile -t sources < <(grep -v '^#' lib/sources.txt | sed 's,^,lib/,')
gcc -std=c99 -pedantic -Wall -Wextra -Werror -O2 -Ilib/include -o "$work/example" \
    "$work/example.c" "${sources[@]}" || fail "the program does not compile"
"$work/example" >"$work/output" || fail "the program exits with $?"
diff -u "$work/expected" "$work/output" >&2 || fail "the program prints something else"
echo "check_readme: the program ($lines lines) compiles, runs and prints what the README says"
