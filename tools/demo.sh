#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -euo pipefail

usage() {
    cat <<'HELP'
usage: tools/demo.sh

The main job on real input, on a bare Debian 12, as root or with sudo: installs
what is missing, builds, and runs `ocellus detect` on two photographs and on a
rendered sequence of a moving ball, streamed line by line as RGB565; then
`ocellus-sim run` on the paper's scenarios in small. Prints the results and
writes annotated pictures to build/demo/. May be run again and again.
HELP
}

case "${1:-}" in
"") ;;
-h | --help) usage && exit 0 ;;
*) usage >&2 && exit 2 ;;
esac

cd "$(dirname "$0")/.."
photos=build/third_party/photos
bin=build/host/bin
out=build/demo
ball_colour=hsv:5-45,125-255,40-255

step() {
    printf '\n== %s\n' "$1"
}

# Runs a command; its output is shown only when it fails.
quietly() {
    local log
    log="$(mktemp)"
    if ! "$@" >"$log" 2>&1; then
        cat "$log" >&2
        rm -f "$log"
        echo "demo: failed: $*" >&2
        exit 1
    fi
    rm -f "$log"
}

# Shows and runs a detection. Exit code 1 is an answer too; 2 ends the demo.
detect() {
    printf '$ ocellus detect %s\n' "$*"
    "$bin/ocellus" detect "$@" || [ $? -eq 1 ]
}

step "1/6 installing what is missing"
tools/setup.sh demo

step "2/6 building (build/host)"
quietly cmake --preset host -DBUILD_TESTING=OFF
quietly cmake --build --preset host --target ocellus_cli ball_sequence ocellus_sim
mkdir -p "$out"
echo "built $("$bin/ocellus" --version)"

step "3/6 the cup in coffee.png: its rim, taught from a rectangle on the porcelain"
detect --teach "178,80,8,48" --annotate "$out/coffee.png" "$photos/coffee.png"

step "4/6 the largest coin in coins.png, by its grey"
detect --colour "gray:122-255" --annotate "$out/coins.png" "$photos/coins.png"

step "5/6 a rendered ball in 24 frames, fed line by line as RGB565"
rm -rf "$out/frames" "$out/annotated"
mkdir -p "$out/annotated"
"$bin/ball_sequence" --out "$out/frames" --frames 24
echo "\$ ocellus detect --colour $ball_colour --format rgb565 \\"
echo "      --annotate $out/annotated $out/frames/frame_*.png"
"$bin/ocellus" detect --colour "$ball_colour" --format rgb565 --annotate "$out/annotated" \
    "$out"/frames/frame_*.png >"$out/sequence.jsonl" || [ $? -eq 1 ]
head -n 1 "$out/sequence.jsonl"
echo "..."
tail -n 1 "$out/sequence.jsonl"
python3 - "$out/frames/truth.csv" "$out/sequence.jsonl" <<'PY'
import csv, json, math, os, sys

truth = {row["file"]: row for row in csv.DictReader(open(sys.argv[1]))}
answers = [json.loads(line) for line in open(sys.argv[2])]
errors = {}
for answer in answers:
    name, ellipse = os.path.basename(answer["file"]), answer.get("ellipse")
    row, text = truth[name], "no ellipse"
    if ellipse:
        error = math.hypot(ellipse["cx"] - float(row["cx"]), ellipse["cy"] - float(row["cy"]))
        errors.setdefault(answer["status"], []).append(error)
        text = "centre (%7.2f, %7.2f)  radius %5.2f  error of the centre %.3f px" % (
            ellipse["cx"], ellipse["cy"], (ellipse["a"] + ellipse["b"]) / 2, error)
    print("%s  %-8s %s" % (name, answer["status"], text))
for status, values in errors.items():
    print("%s: %d frames, error of the centre: mean %.3f px, largest %.3f px" % (
        status, len(values), sum(values) / len(values), max(values)))
PY

step "6/6 the paper's scenarios in a simulated world, three trials a point"
for scenario in a_cylinder b_occlusion c_distance; do
    echo "\$ ocellus-sim run hostsim/scenarios/$scenario.toml --out $out/$scenario --trials 3"
    "$bin/ocellus-sim" run "hostsim/scenarios/$scenario.toml" --out "$out/$scenario" --trials 3 \
        --jobs "$(nproc)"
done

step "done"
echo "annotated pictures: $out/coffee.png $out/coins.png $out/annotated/frame_*.png"
echo "the simulator's: $out/{a_cylinder,b_occlusion,c_distance}/{pictures/,trials.csv,summary.json}"
echo "the sequence's JSON, one line a frame: $out/sequence.jsonl"
