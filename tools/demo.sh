#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -euo pipefail

usage() {
    cat <<'HELP'
usage: tools/demo.sh

The main job on real input, on a bare Debian 12, as root or with sudo: installs
what is missing, builds, and runs `ocellus detect` on two photographs and on a
rendered sequence of a moving ball, streamed line by line as RGB565; then
`ocellus-sim paper` with few trials and `ocellus-sim track` with a video. Writes
annotated pictures, the report and the video to build/demo/ and ends with their
paths. May be run again and again.
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
trials=10

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

# Shows and runs a command of the simulator.
run_sim() {
    printf '$ ocellus-sim %s\n' "$*"
    "$bin/ocellus-sim" "$@"
}

step "1/7 installing what is missing"
tools/setup.sh demo

step "2/7 building (build/host)"
quietly cmake --preset host -DBUILD_TESTING=OFF
quietly cmake --build --preset host --target ocellus_cli ball_sequence ocellus_sim
mkdir -p "$out"
echo "built $("$bin/ocellus" --version)"

step "3/7 the cup in coffee.png: its rim, taught from a rectangle on the porcelain"
detect --teach "178,80,8,48" --annotate "$out/coffee.png" "$photos/coffee.png"

step "4/7 the largest coin in coins.png, by its grey"
detect --colour "gray:122-255" --annotate "$out/coins.png" "$photos/coins.png"

step "5/7 a rendered ball in 24 frames, fed line by line as RGB565"
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

step "6/7 the paper's experiments in a simulated world, $trials trials a point"
run_sim paper --out "$out/paper" --trials "$trials" --jobs "$(nproc)"

step "7/7 the closed loop: the head follows a thrown ball, as a video"
run_sim track hostsim/scenarios/track_throw.toml --out "$out/paper/track_throw" --video
run_sim report "$out/paper"

step "done"
echo "annotated pictures: $out/coffee.png $out/coins.png $out/annotated/frame_*.png"
echo "the sequence's JSON, one line a frame: $out/sequence.jsonl"
echo "the video:  $out/paper/track_throw/track.mp4"
echo "the report: $out/paper/report.html (open it in a browser; it needs no other file)"
