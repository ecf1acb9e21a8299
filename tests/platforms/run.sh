#!/usr/bin/env bash
# The physics library on other systems and processors: builds it there with a cross compiler and runs it in an emulator.
#
#   run.sh --list                        the names of the platforms
#   run.sh hashes PLATFORM BUILD         writes BUILD/PLATFORM/hashes.txt, what `scene_hashes` prints there
#   run.sh package webassembly BUILD     makes the npm package in BUILD/webassembly/package
#   run.sh tests PLATFORM BUILD          runs the tests of physics, of its interface in C and of the property tree there
#
# Exit status 77, with the reason in the last line: the platform cannot be tried here.
set -euo pipefail
project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
platforms=(windows aarch64 webassembly)

if [[ ${1:-} == --list ]]; then
    printf '%s\n' "${platforms[@]}"
    exit
fi
platform=$2
mkdir -p -- "$3/$platform"
folder=$(cd -- "$3/$platform" && pwd -P)

cannot() { printf '%s\n' "$*"; exit 77; }
needs() { command -v "$1" >/dev/null || cannot "$1 is not here"; }

parts='physics;physics_c;property' tests='determinism;physics;physics_c;property'
case $platform in
    windows)
        needs x86_64-w64-mingw32-g++-posix
        needs wine
        # A Windows of its own, without the windows and the sounds of this machine.
        export WINEPREFIX=$folder/wine WINEDEBUG=-all DISPLAY=
        mkdir -p -- "$WINEPREFIX"
        ;;
    aarch64)
        needs aarch64-linux-gnu-g++
        needs qemu-aarch64
        ;;
    webassembly)
        needs em++
        needs node
        export NODE_PATH=/usr/share/nodejs  # of Debian's emscripten, for a node that is not Debian's
        parts='physics;physics_c' tests=determinism
        ;;
    *) cannot "there is no platform $platform" ;;
esac

# build TARGET...
build() {
    cmake -S "$project" -B "$folder" -G Ninja --toolchain "$project/cmake/toolchains/$platform.cmake" \
        -DCMAKE_BUILD_TYPE=Release -DFETTLE_PARTS="$parts" -DFETTLE_TEST_FOLDERS="$tests" \
        -DFETTLE_BUILD_TESTS=ON -DFETTLE_BUILD_BENCH=OFF -DFETTLE_INSTALL=OFF
    cmake --build "$folder" -j "$(nproc)" --target "$@"
}

# ctest knows the emulator; a test program is one test here.
run_hashes() {
    build scene_hashes
    (cd -- "$folder" && ctest -R '^scene_hashes$' -V) | tr -d '\r' | sed -n 's/^[0-9]*: \([a-z_]* [0-9a-f]\{16\}\)$/\1/p' \
        >"$folder/hashes.txt"
    cat -- "$folder/hashes.txt"
    grep -q '^all ' "$folder/hashes.txt"
}

run_tests() {
    local targets=() name
    for name in ${tests//;/ }; do [[ $name == determinism ]] || targets+=("test_$name"); done
    [[ ";$tests;" != *";physics;"* ]] || targets+=(test_physics_families)
    build "${targets[@]}"
    cd -- "$folder"
    ctest --output-on-failure --timeout 3000 -E '^(scene_hashes|determinism)$'
}

run_package() { build fettle_web; }

"run_$1"
