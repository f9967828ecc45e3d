#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -uo pipefail

usage() {
    cat <<'HELP'
usage: tools/check_format.sh [--update]

Claim: every C and C++ file of lib, tests, hostsim and port is as clang-format 19
leaves it with the repository's .clang-format.  --update formats them.
HELP
}
update=no
case "${1:-}" in -h | --help) usage && exit 0 ;; --update) update=yes ;; "") ;; *) usage >&2 && exit 2 ;; esac

cd "$(dirname "$0")/.." || exit 1
format="${CLANG_FORMAT:-clang-format-19}"
command -v "$format" >/dev/null || {
    echo "check_format: no $format here; run tools/setup.sh test" >&2
    exit 1
}
mapfile -t files < <(find lib tests hostsim port -type f \
    \( -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.hpp' \) | sort)
if [ "$update" = yes ]; then
    "$format" -i "${files[@]}"
elif "$format" --dry-run -Werror "${files[@]}"; then
    echo "check_format: ${#files[@]} files, all formatted"
else
    echo "check_format: FAILED. Run tools/check_format.sh --update" >&2
    exit 1
fi
