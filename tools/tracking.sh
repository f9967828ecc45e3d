#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/tracking.sh [--check FILE | --update FILE]

Claim: what the closed loop of the simulator reaches, that is, how well the head
holds the ball of each hostsim/scenarios/track_*.toml and how well the library
knows where it is. Runs them (10 s), leaves their results in
build/host/reports/track_*/ and the table in build/host/reports/tracking.md, and
prints it. Fails when a figure misses what is asked. --check compares the table
with the block <!-- tracking:begin --> of FILE, within 10 %; --update writes it
there. Needs the preset host built.
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
program=build/host/bin/ocellus-sim reports=build/host/reports
if [ ! -x "${OCELLUS_SIM:=$program}" ]; then
    echo "tracking: no $OCELLUS_SIM; run cmake --preset host && cmake --build --preset host" >&2
    exit 1
fi
mkdir -p $reports
failed=0

for scenario in roll throw bounce occluded; do
    "$OCELLUS_SIM" track "hostsim/scenarios/track_$scenario.toml" \
        --out "$reports/track_$scenario" >/dev/null 2>"$reports/tracking.log" ||
        { cat "$reports/tracking.log" >&2 && exit 1; }
done

python3 - $reports >$reports/tracking.md <<'PY' || failed=1
import json, pathlib, sys

def rms(error):
    return f"{error['rms']:.4f}"

print("""| scenario | frames | ball hidden | held | farthest off, px | error, `ok` frames | guesses too | `ok` while hidden | taken again in |
|---|--:|--:|--:|--:|--:|--:|--:|--:|""")
met = True
for name in ("track_roll", "track_throw", "track_bounce", "track_occluded"):
    s = json.loads((pathlib.Path(sys.argv[1]) / name / "summary.json").read_text())
    again = f"{s['reacquired_frames_max']} frames" if s["gaps"] else ""
    print(f"| `{name}` | {s['frames']} | {s['hidden_frames']} | {100 * s['held_share']:.1f} % "
          f"| {s['off_px']['max']:.1f} | {rms(s['err'])} | {rms(s['err_visible'])} "
          f"| {s['ok_while_hidden']} | {again} |")
    met = met and all(s["met"].values())
asked = s["asked"]
print(f"| asked | | | {100 * asked['held_share']:.0f} % | | {asked['err_rms']} | "
      f"| {asked['ok_while_hidden']} | |")
sys.exit(0 if met else 1)
PY

case "$mode" in
print) cat $reports/tracking.md ;;
check | update)
    python3 tools/readme_block.py "--$mode" --tolerance 10 \
        --fix "Run tools/tracking.sh --update $file" "$file" tracking $reports/tracking.md || failed=1
    ;;
esac
if [ "$failed" -ne 0 ]; then
    echo "tracking: FAILED; the table is $reports/tracking.md" >&2
    exit 1
fi
echo "tracking: all that is asked is met; the table is $reports/tracking.md" >&2
