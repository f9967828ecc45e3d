#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/coverage.sh [--html]

Builds and runs the unit tests under the preset cov and prints the coverage of
lib/src by file: lines, branches and MC/DC (clang).  --html writes pages to
build/cov/html as well.  Every variant of the library counts.
HELP
}
html=no
case "${1:-}" in -h | --help) usage && exit 0 ;; --html) html=yes ;; "") ;; *) usage >&2 && exit 2 ;; esac

cd "$(dirname "$0")/.." || exit 1
for tool in clang-19 llvm-cov-19 llvm-profdata-19; do
    command -v "$tool" >/dev/null || {
        echo "coverage: no $tool here; run tools/setup.sh test" >&2
        exit 1
    }
done
cmake --preset cov >/dev/null && cmake --build --preset cov >/dev/null || exit 1
rm -rf build/cov/profile
ctest --preset cov -L unit || exit 1
profile=build/cov/coverage.profdata
llvm-profdata-19 merge -sparse build/cov/profile/*.profraw -o "$profile" || exit 1
programs=(build/cov/bin/test_*)
objects=("${programs[0]}") # the first by its place, the others by option
for program in "${programs[@]:1}"; do objects+=(-object "$program"); done
# Everything below lib/ counts, the helpers in headers as well.
llvm-cov-19 report "${objects[@]}" -instr-profile="$profile" -show-mcdc-summary \
    -show-region-summary=false "$PWD/lib" | tee build/cov/coverage.txt
if [ "$html" = yes ]; then
    llvm-cov-19 show "${objects[@]}" -instr-profile="$profile" -show-mcdc -show-branches=count \
        -format=html -output-dir=build/cov/html "$PWD/lib" &&
        echo "coverage: pages in build/cov/html/index.html"
fi
