#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/test.sh [--no-setup]

Installs what is missing (tools/setup.sh test), then configures, builds and
tests the presets host and asan and those of the emulated boards (m0 to rv32,
port/README.md), then runs the gate (tools/gate.sh).  Every step runs even when an
earlier one failed; the summary at the end says which did, and the exit status is
0 only when none did.
HELP
}

setup=yes
case "${1:-}" in
-h | --help) usage && exit 0 ;;
--no-setup) setup=no ;;
"") ;;
*) usage >&2 && exit 2 ;;
esac

cd "$(dirname "$0")/.." || exit 1
summary=()
failed=0

step() { # NAME COMMAND...: runs it, and notes how it went and how long it took
    local name="$1" begun="$SECONDS" verdict=passed
    shift
    printf '\n=== %s: %s\n' "$name" "$*"
    "$@" || { verdict=FAILED && failed=1; }
    summary+=("$(printf '%-7s %4d s  %s' "$verdict" $((SECONDS - begun)) "$name")")
    [ "$verdict" = passed ]
}

if [ "$setup" = yes ]; then
    step setup tools/setup.sh test || { printf '%s\n' "${summary[@]}" && exit 1; }
fi
for preset in host asan m0 m3 m4 m7 m33 m55 rv32; do
    step "$preset: configure" cmake --preset "$preset" &&
        step "$preset: build" cmake --build --preset "$preset" &&
        step "$preset: tests" ctest --preset "$preset"
done
step gate tools/gate.sh

printf '\n=== summary\n'
printf '%s\n' "${summary[@]}"
printf 'total %d s\n' "$SECONDS"
exit "$failed"
