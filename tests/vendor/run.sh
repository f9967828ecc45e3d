#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -euo pipefail

usage() {
    cat <<'HELP'
usage: tests/vendor/run.sh subdirectory|makefile|cplusplus|installed

Claim: lib/ can be taken the way people do.  Copies lib/, port/ and the project
elsewhere, builds the project there, runs it (a firmware for Cortex-M4 under QEMU;
`installed` on the host, against what cmake --install put down) and asks that it
finds the ball in its frame.
HELP
}
case "${1:-}" in
subdirectory | makefile | cplusplus | installed) project="$1" ;;
-h | --help) usage && exit 0 ;;
*) usage >&2 && exit 2 ;;
esac

here="$(cd "$(dirname "$0")" && pwd)"
root="$(cd "$here/../.." && pwd)"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
cp -r "$root/lib" "$work/ocellus"
cp -r "$root/port" "$here/$project" "$here/frame.h" "$work/"

build() { # CMAKE OPTIONS...: the project into $work/build
    cmake -S "$work/$project" -B "$work/build" -DCMAKE_BUILD_TYPE=Release "$@" >"$work/log" 2>&1 &&
        cmake --build "$work/build" -j 2 >>"$work/log" 2>&1 || {
        cat "$work/log" >&2
        return 1
    }
}

if [ "$project" = installed ]; then
    for step in "-S $work/ocellus -B $work/lib -DCMAKE_BUILD_TYPE=Release" "--build $work/lib -j 2" \
        "--install $work/lib --prefix $work/prefix"; do
        # shellcheck disable=SC2086  # the step is words
        cmake $step >"$work/log" 2>&1 || { cat "$work/log" >&2 && exit 1; }
    done
    rm -r "${work:?}/ocellus" "${work:?}/lib" # nothing may refer to them any more
    build -DCMAKE_PREFIX_PATH="$work/prefix"
    "$work/build/consumer"
    exit 0
fi

firmware="$work/build/firmware"
if [ "$project" = makefile ]; then
    make -s -C "$work/makefile" -j 2
    firmware="$work/makefile/firmware.elf"
else
    build -DCMAKE_TOOLCHAIN_FILE="$work/port/arm/toolchain.cmake" \
        "-DOCEL_ARM_CPU=-mcpu=cortex-m4;-mfloat-abi=soft"
fi
arm-none-eabi-size "$firmware"
timeout 60 qemu-system-arm -M mps2-an386 -display none -monitor none -serial null \
    -chardev stdio,id=text -semihosting-config enable=on,target=native,chardev=text \
    -kernel "$firmware" </dev/null
