#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/gate.sh [CHECK...]

Runs every check of the gate, two at a time, or the named ones (as listed by
tools/gate.sh --list); each is a script of its own with --help.  All run,
whatever fails.
HELP
}

# One line a claim: the name, and the script that holds it.
checks=(
    "selftest   tools/gate_selftest.sh"
    "figures    tools/figures.sh --check tests/FIGURES.md"
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
    "tracking   tools/tracking.sh --check hostsim/README.md"
    "headlines  tools/headlines.py --check README.md"
)

case "${1:-}" in
-h | --help) usage && exit 0 ;;
--list) printf '%s\n' "${checks[@]}" && exit 0 ;;
esac

cd "$(dirname "$0")/.." || exit 1
logs="$(mktemp -d)"
trap 'rm -rf "$logs"' EXIT
chosen=()
for check in "${checks[@]}"; do
    read -r name _ <<<"$check"
    if [ "$#" -eq 0 ] || [[ " $* " == *" $name "* ]]; then chosen+=("$check"); fi
done
if [ "${#chosen[@]}" -eq 0 ]; then
    echo "gate: no check named $*; see tools/gate.sh --list" >&2
    exit 2
fi

run() { # NAME SCRIPT...: its output, verdict and seconds go into files of that name
    local name="$1" begun="$SECONDS" verdict=passed
    shift
    "$@" >"$logs/$name.out" 2>&1 || verdict=FAILED
    printf '%-7s %4d s  gate: %s\n' "$verdict" $((SECONDS - begun)) "$name" >"$logs/$name.verdict"
}

# Two at a time, the longest first.
started=0
for check in "${chosen[@]}"; do
    [ "$started" -lt 2 ] || wait -n
    # shellcheck disable=SC2086  # the script's own options are words
    run $check &
    started=$((started + 1))
done
wait

failed=0
summary=()
for check in "${chosen[@]}"; do
    read -r name script <<<"$check"
    printf '\n--- %s: %s\n' "$name" "$script"
    cat "$logs/$name.out"
    summary+=("$(cat "$logs/$name.verdict")")
    [[ "${summary[-1]}" != FAILED* ]] || failed=1
done
printf '\n'
printf '%s\n' "${summary[@]}"
exit "$failed"
