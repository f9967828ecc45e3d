#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/check_misra.sh [--update | --list [RULE]]

Claim: every finding of cppcheck 2.22 with its MISRA C:2012 addon in lib/ stands
in the ledger lib/MISRA.md with its rule, count, places and reason, and nothing
else stands there.  --update writes the counts and places (a new rule gets the
reason TODO, which fails); --list prints the findings, of one rule when named.
HELP
}
mode=check rule=""
case "${1:-}" in
-h | --help) usage && exit 0 ;;
--update) mode=update ;;
--list) mode=list rule="${2:-}" ;;
"") ;;
*) usage >&2 && exit 2 ;;
esac

cd "$(dirname "$0")/.." || exit 1
cppcheck="$PWD/build/third_party/cppcheck/cppcheck"
if [ "$("$cppcheck" --version 2>/dev/null)" != "Cppcheck 2.22.0" ]; then
    echo "check_misra: no cppcheck 2.22 at $cppcheck; run tools/setup.sh test" >&2
    exit 1
fi
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# The counts are of one analysis of the whole library on a 32-bit machine under
# the default limits, each place once.  Rule texts are not ours to publish, so
# the addon prints none.
mapfile -t sources < <(grep -v '^#' lib/sources.txt | sed 's,^,lib/,')
mkdir "$work/dumps" # else the dumps stand beside the sources while it runs
"$cppcheck" --cppcheck-build-dir="$work/dumps" --addon=misra --std=c99 --platform=unix32 --max-configs=1 --quiet \
    --enable=warning,performance,portability,style --inline-suppr \
    --suppress=missingIncludeSystem --suppress=unmatchedSuppression \
    -D__GNUC__=12 -Ilib/include -Ilib/src \
    --template='{file}:{line}:{column}:{id}:{message}' "${sources[@]}" 2>"$work/raw" || {
    cat "$work/raw" >&2
    exit 1
}
grep -E '^lib/[^:]+:[0-9]+:[0-9]+:' "$work/raw" | sort -u -t: -k1,1 -k2,2n -k3,3n -k4,4 >"$work/findings"
if grep -qvE '^lib/[^:]+:[0-9]+:[0-9]+:' "$work/raw"; then
    grep -vE '^lib/[^:]+:[0-9]+:[0-9]+:' "$work/raw" >&2
    echo "check_misra: FAILED: cppcheck did not understand the lines above" >&2
    exit 1
fi
if [ "$mode" = list ]; then
    sed 's/misra-c2012-//; s/misra violation.*//' "$work/findings" | awk -F: -v rule="$rule" \
        'rule == "" || $4 == rule { print $1 ":" $2 ":" $3 ": " $4 " " $5 }'
    exit 0
fi
python3 tools/misra_ledger.py "--$mode" lib/MISRA.md "$work/findings"
