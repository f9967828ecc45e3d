#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/check_vendored.sh

Claim: lib/ is whole by itself.  Copies it elsewhere and builds a small consumer
against it in three ways: CMake's add_subdirectory, the same under other limits,
and a plain Makefile that reads lib/sources.txt.
HELP
}
case "${1:-}" in -h | --help) usage && exit 0 ;; "") ;; *) usage >&2 && exit 2 ;; esac

cd "$(dirname "$0")/.." || exit 1
for tool in cmake make cc; do
    command -v "$tool" >/dev/null || {
        echo "check_vendored: no $tool here; run tools/setup.sh" >&2
        exit 1
    }
done
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
mkdir "$work/vendor"
cp -r lib "$work/vendor/ocellus"

cat >"$work/main.c" <<'C'
#include <ocellus/ocellus.h>
#include <stdio.h>

static ocel_eye_t eye;

int main(void) {
    ocel_eye_config_t config = {.width = OCEL_MAX_WIDTH, .height = OCEL_MAX_HEIGHT};
    printf("%d %s\n", OCEL_MAX_WIDTH, ocel_status_name(ocel_eye_init(&eye, &config)));
    return 0;
}
C
cat >"$work/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES C)
add_subdirectory(vendor/ocellus)
get_target_property(version ocellus VERSION)
if(NOT version MATCHES "^[0-9]+[.][0-9]+[.][0-9]+$")
  message(FATAL_ERROR "no version: '${version}'")
endif()
get_target_property(options ocellus INTERFACE_COMPILE_OPTIONS)
if(options)
  message(FATAL_ERROR "the library forces compile options on its consumer: ${options}")
endif()
add_executable(consumer main.c)
target_link_libraries(consumer PRIVATE ocellus::ocellus)
CMAKE
cat >"$work/Makefile" <<'MAKE'
LIB := vendor/ocellus
SRC := $(addprefix $(LIB)/,$(shell grep -v '^\#' $(LIB)/sources.txt))
OBJ := $(SRC:.c=.o)
CPPFLAGS += -I$(LIB)/include
CFLAGS += -std=c99 -O2

consumer: main.o $(OBJ)
	$(CC) $(LDFLAGS) -o $@ $^
$(OBJ): CFLAGS += -Werror
MAKE

failed=0
expect() { # NAME PROGRAM EXPECTED: what the consumer prints
    local output
    output="$("$2" 2>&1)"
    if [ "$output" != "$3" ]; then
        echo "check_vendored: $1: the consumer printed '$output', not '$3'" >&2
        failed=1
    fi
}
attempt() { # NAME COMMAND...
    local name="$1"
    shift
    if ! "$@" >"$work/log" 2>&1; then
        cat "$work/log" >&2
        echo "check_vendored: $name does not build outside the repository;" \
            "lib/ must not refer to anything above it" >&2
        failed=1
        return 1
    fi
}
width="$(sed -n 's/^#define OCEL_MAX_WIDTH \([0-9]*\)$/\1/p' lib/include/ocellus/config.h)"

attempt "add_subdirectory" cmake -S "$work" -B "$work/b1" &&
    attempt "add_subdirectory" cmake --build "$work/b1" -j 2 &&
    expect "add_subdirectory" "$work/b1/consumer" "$width ok"
attempt "other limits" cmake -S "$work" -B "$work/b2" -DOCEL_MAX_WIDTH=640 -DOCEL_MAX_HEIGHT=480 &&
    attempt "other limits" cmake --build "$work/b2" -j 2 &&
    expect "other limits" "$work/b2/consumer" "640 ok"
attempt "Makefile" make -C "$work" -j 2 &&
    expect "Makefile" "$work/consumer" "$width ok"

if [ "$failed" -ne 0 ]; then
    echo "check_vendored: FAILED" >&2
    exit 1
fi
echo "check_vendored: lib/ alone builds with add_subdirectory, other limits and a Makefile"
