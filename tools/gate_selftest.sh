#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/gate_selftest.sh [WORD]

Claim: the gate can fail.  In a copy of the repository, seeds one violation
after the other, and expects the check that guards against it to fail and to
say why.  With WORD, only the violations whose name contains it.
HELP
}
case "${1:-}" in -h | --help) usage && exit 0 ;; esac
only="${1:-}"

root="$(cd "$(dirname "$0")/.." && pwd)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cd "$root" || exit 1
cp -r CMakeLists.txt CMakePresets.json README.md .clang-format lib port tools "$work"
mkdir -p "$work/tests" "$work/hostsim" "$work/build"
ln -s "$root/build/third_party" "$work/build/third_party"
cp -r "$work/lib" "$work/lib.clean"
cp "$work/README.md" "$work/README.clean"
cd "$work" || exit 1

seeded=0 missed=0

# caught NAME PATTERN CHECK...: the check must fail and print PATTERN.  Each
# seed is put into the copy before, and taken out after.
caught() {
    local name="$1" pattern="$2" output status
    shift 2
    if [ -n "$only" ] && [[ "$name" != *"$only"* ]]; then
        restore
        return
    fi
    seeded=$((seeded + 1))
    output="$("$@" 2>&1)"
    status=$?
    if [ "$status" -eq 0 ]; then
        echo "gate_selftest: MISSED: $name passes $1" >&2
        missed=1
    elif ! grep -q -- "$pattern" <<<"$output"; then
        printf 'gate_selftest: MISSED: %s: %s fails, but not with "%s":\n%s\n' \
            "$name" "$1" "$pattern" "$output" >&2
        missed=1
    else
        echo "caught: $name"
    fi
    restore
}
restore() { # only what differs, so that the next build is of that alone
    local file
    diff -rq lib.clean lib | sed -n 's,^Files lib.clean/\(.*\) and .*,\1,p; s,^Only in lib\(\.clean\)\{0\,1\}\(.*\): \(.*\),\2/\3,p' |
        while read -r file; do
            rm -rf "lib/$file"
            [ ! -e "lib.clean/$file" ] || cp "lib.clean/$file" "lib/$file"
        done
    cp README.clean README.md
}
seed() { cat >>"lib/src/base/status.c"; } # code from stdin at the end of a module

seed <<<'int ocel_seed(int a); int ocel_seed(int a) { int unused; return a; }'
caught "an unused variable" "unused" tools/check_warnings.sh src/base/status.c
seed <<<'int ocel_seed(void); int ocel_seed(void) { int *p = (int *)0; return *p; }'
caught "a null pointer read, by gcc's analyser" "null" tools/check_warnings.sh src/base/status.c
echo 'typedef int ocel_seed_t; static inline int ocel_seed(int class) { return class; }' \
    >>lib/include/ocellus/config.h
caught "a header that is no C++" "config.h" tools/check_warnings.sh src/base/status.c

seed <<<'int   badly_formatted ;'
caught "bad formatting" "clang-format" tools/check_format.sh

seed <<<'int ocel_seed(int a); int ocel_seed(int a) { return (int)((float)a * 1.5f); }'
caught "a float" "float" tools/check_symbols.sh
seed <<<'int ocel_seed(void); int ocel_seed(void) { static int calls; return ++calls; }'
caught "global state" "has state" tools/check_symbols.sh
seed <<<'long long ocel_seed(long long a, long long b);
long long ocel_seed(long long a, long long b) { return a / b; }'
caught "a 64-bit division" "__aeabi_ldivmod" tools/check_symbols.sh
seed <<<'void *malloc(unsigned long n); void *ocel_seed(void); void *ocel_seed(void) { return malloc(9); }'
caught "the heap" "malloc" tools/check_symbols.sh

sed -i '1i #include <ocellus/label.h>' lib/src/colour/colour.c
caught "a stage that includes another" "stages meet" tools/check_ranks.py
sed -i '1i #include <ocellus/fit.h>' lib/src/base/int_math.h
caught "an include of a higher rank" "rank" tools/check_ranks.py
sed -i '1i #include <stdio.h>' lib/src/eye/eye.c
caught "a header for I/O" "stdio.h" tools/check_ranks.py
mv lib/src/fit/arc.c lib/src/eye/arc.c
caught "a source file in another stage's folder" "its stage is" tools/check_ranks.py
echo >lib/src/base/forgotten.c
caught "a source file that no list has" "sources.txt" tools/check_ranks.py

seed <<<'int ocel_seed(int n); int ocel_seed(int n) { while (n > 9) { n /= 2; } return n; }'
caught "a loop without a bound" "no .bound:" tools/check_loops.py

seed <<<'int ocel_seed(int a); int ocel_seed(int a) { if (a > 1) goto out; a = 2; out: return a; }'
caught "a goto" "15.1" tools/check_misra.sh
sed -i '/^| 8.7 /d' lib/MISRA.md
caught "a deviation without a row" "not in the ledger" tools/check_misra.sh

echo '#define OCEL_SEED 1' >port/seed.h
sed -i '1i #include "../../port/seed.h"' lib/src/base/status.c
caught "a reference from lib/ to outside" "does not build" tools/check_vendored.sh

seed <<<'int ocel_seed(int n); int ocel_seed(int n) { return (n < 2) ? 1 : n * ocel_seed(n - 1) + ocel_seed(n - 2); }'
sed -i '/^const char \*ocel_status_name/i int ocel_seed(int n);' lib/include/ocellus/status.h
caught "a recursion" "recursion" tools/sizes.sh
seed <<<'int ocel_seed(int n, int (*f)(int)); int ocel_seed(int n, int (*f)(int)) { return f(n) + 1; }'
sed -i '/^const char \*ocel_status_name/i int ocel_seed(int n, int (*f)(int));' lib/include/ocellus/status.h
caught "a call through a pointer" "through a pointer" tools/sizes.sh
seed <<<'int ocel_seed(int n); int ocel_seed(int n) { volatile char big[1200]; big[n] = 1; return big[0]; }'
sed -i '/^const char \*ocel_status_name/i int ocel_seed(int n);' lib/include/ocellus/status.h
caught "a deep stack" "over 1024" tools/sizes.sh
sed -i '1i #define ocel_label_begin ocel_seed_begin' lib/src/eye/eye.c
cat >>lib/src/label/label.c <<'C'
ocel_status_t ocel_seed_begin(ocel_labeller_t *labeller, ocel_crack_pool_t *pool, uint16_t width,
                              uint16_t height, ocel_connectivity_t connectivity);
ocel_status_t ocel_seed_begin(ocel_labeller_t *labeller, ocel_crack_pool_t *pool, uint16_t width,
                              uint16_t height, ocel_connectivity_t connectivity) {
    static const char big[16384] = {1};
    return ocel_label_begin(labeller, pool, width, (uint16_t)(height + big[width]), connectivity);
}
C
caught "too much code" "code" tools/sizes.sh
sed -i 's/#define OCEL_MAX_CRACKS 2048/#define OCEL_MAX_CRACKS 2049/' lib/include/ocellus/config.h
caught "too large a context" "the boundary pool" tools/sizes.sh
sed -i '/<!-- sizes:begin -->/,/<!-- sizes:end -->/s/^| status | \([0-9]*\) /| status | 1\1 /' lib/COSTS.md
caught "a wrong size in the README" "not what was measured" tools/sizes.sh --check lib/COSTS.md

sed -i '/<!-- example:output -->/,$s/[0-9]/7/g' README.md
caught "an example that prints something else" "prints something else" tools/check_readme.sh
sed -i '/<!-- example:program -->/,$s/ocel_eye_begin\|ocel_eye_frame/ocel_eye_seed/' README.md
caught "an example that does not compile" "does not compile" tools/check_readme.sh

printf '%s\n' '<!-- t:begin -->' '| a | OpenCV b |' '|---|---|' '| 1000 | 1000 |' '<!-- t:end -->' >block.md
printf '%s\n' '| a | OpenCV b |' '|---|---|' '| 1030 | 1000 |' >measured.md
compare=(tools/readme_block.py --check --tolerance 2 --loose OpenCV block.md t measured.md)
caught "a figure that is 3 % off" "not what was measured" "${compare[@]}"
printf '%s\n' '| a | OpenCV b |' '|---|---|' '| 1010 | 2100 |' >measured.md
caught "a figure of OpenCV that has doubled" "not what was measured" "${compare[@]}"
printf '%s\n' '| a | OpenCV b |' '|---|---|' '| 1010 | 1400 |' >measured.md
"${compare[@]}" || { echo "gate_selftest: figures within tolerance are refused" >&2 && missed=1; }

cat >stage_cost <<'STAGE'
#!/bin/sh
echo "eye_frame;a frame;76800;1"
STAGE
chmod +x stage_cost
echo 'target,function,input,instructions' >budgets.csv
printf 'host,%s,a frame,1\n' eye_frame another >>budgets.csv
caught "a budget for no stage" "is not measured" \
    tools/cycles.py ./stage_cost --out . --budgets budgets.csv
program="$root/build/host/bin/stage_cost"
if [ -x "$program" ]; then
    sed 's/^\(host,.*\),[0-9]*$/\1,1/' "$root/tests/budgets.csv" >budgets.csv
    caught "a stage over its budget" "over its budget" \
        tools/cycles.py "$program" --out . --budgets budgets.csv
fi

if [ "$missed" -ne 0 ]; then
    echo "gate_selftest: FAILED: a check let a violation through" >&2
    exit 1
fi
echo "gate_selftest: $seeded seeded violations, each caught by its check"
