#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/figures.sh [--check FILE | --update FILE]

Claim: the measured figures of tests/FIGURES.md, and their limits: what a
frame and a fit cost, beside OpenCV in the same run (callgrind), and how
accurate the fits are (the accuracy programs of tests/accuracy).  Writes
build/host/reports/figures.md and prints it; --check compares it with the block
<!-- figures:begin --> of FILE, within 2 % (columns of OpenCV, whose code follows
the processor, within 50 %); --update writes it there.  Needs the preset host
built.
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
bin=build/host/bin reports=build/host/reports
if [ ! -x $bin/frame_cost ]; then
    echo "figures: no $bin/frame_cost; run cmake --preset host && cmake --build --preset host" >&2
    exit 1
fi
mkdir -p $reports
failed=0

# The accuracy programs' tables; ctest has just made them, or they are made here.
accuracy=(disc_masks exact_arcs noisy_arcs ball_range ball_occlusion ball_hard_cases
    head_kinematics tracking)
for name in "${accuracy[@]}"; do
    program="$bin/accuracy_$name" table="$reports/accuracy_$name.txt"
    if [ ! -s "$table" ] || [ "$program" -nt "$table" ]; then
        "$program" "$table" >/dev/null || failed=1
    fi
    if grep -q 'FAILS$' "$table"; then
        grep 'FAILS$' "$table" >&2
        failed=1
    fi
done

{
    python3 tools/frame_figures.py $bin/frame_cost || failed=1
    for name in "${accuracy[@]}"; do
        printf '\n`build/host/bin/accuracy_%s`:\n\n```\n' "$name"
        cat "$reports/accuracy_$name.txt"
        printf '```\n'
    done
} >$reports/figures.md

case "$mode" in
print) cat $reports/figures.md ;;
check | update)
    python3 tools/readme_block.py "--$mode" --tolerance 2 --loose OpenCV --loose-tolerance 50 \
        --fix "Run tools/figures.sh --update $file" "$file" figures $reports/figures.md || failed=1
    ;;
esac
if [ "$failed" -ne 0 ]; then
    echo "figures: FAILED" >&2
    exit 1
fi
echo "figures: within their limits, but for those marked as not reached; the table is $reports/figures.md" >&2
