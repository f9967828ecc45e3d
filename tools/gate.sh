#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/gate.sh [CHECK...]

Runs every check of the gate, or the named ones (as listed by tools/gate.sh
--list); each is a script of its own with --help.  All run, whatever fails.
HELP
}

# One line a claim: the name, and the script that holds it.
checks=(
    "warnings   tools/check_warnings.sh"
    "format     tools/check_format.sh"
    "symbols    tools/check_symbols.sh"
    "ranks      tools/check_ranks.py"
    "loops      tools/check_loops.py"
    "misra      tools/check_misra.sh"
    "vendored   tools/check_vendored.sh"
    "readme     tools/check_readme.sh"
    "sizes      tools/sizes.sh --check lib/COSTS.md"
    "wcet       tools/wcet.py --check lib/COSTS.md"
    "figures    tools/figures.sh --check tests/FIGURES.md"
    "tracking   tools/tracking.sh --check hostsim/README.md"
    "headlines  tools/headlines.py --check README.md"
    "selftest   tools/gate_selftest.sh"
)

case "${1:-}" in
-h | --help) usage && exit 0 ;;
--list) printf '%s\n' "${checks[@]}" && exit 0 ;;
esac

cd "$(dirname "$0")/.." || exit 1
summary=()
failed=0
for check in "${checks[@]}"; do
    read -r name script <<<"$check"
    if [ "$#" -gt 0 ] && [[ " $* " != *" $name "* ]]; then continue; fi
    begun="$SECONDS"
    verdict=passed
    printf '\n--- %s: %s\n' "$name" "$script"
    # shellcheck disable=SC2086  # the script's own options are words
    $script || { verdict=FAILED && failed=1; }
    summary+=("$(printf '%-7s %4d s  gate: %s' "$verdict" $((SECONDS - begun)) "$name")")
done
if [ "${#summary[@]}" -eq 0 ]; then
    echo "gate: no check named $*; see tools/gate.sh --list" >&2
    exit 2
fi
printf '\n'
printf '%s\n' "${summary[@]}"
exit "$failed"
