#!/usr/bin/env bash
# Fettle in programs of other engines and languages: builds and runs each program and checks its picture.
#
#   run.sh --list                 the names of the cases
#   run.sh CASE BUILD FOLDER      BUILD has fettle_physics_c and fettle_host; pictures and what is built go to FOLDER
#
# Exit status 77, with the reason in the last line: the case cannot run here.
set -euo pipefail
project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
cases=(sdl2 sdl2_host python python_installed python_demo love love_demo love_speed love_host love_host_demo web web_demo web_bitecs web_speed guide)

if [[ ${1:-} == --list ]]; then
    printf '%s\n' "${cases[@]}"
    exit
fi
build=$(cd -- "$2" && pwd -P)
mkdir -p -- "$3"
folder=$(cd -- "$3" && pwd -P)
library=$build/bindings/c/libfettle_physics_c.so
host=$build/bindings/host/libfettle_host.so
python=/usr/bin/python3  # Debian's, whatever else is in PATH
export SDL_AUDIODRIVER=dummy SDL_RENDER_DRIVER=software

cannot() { printf '%s\n' "$*"; exit 77; }
needs() { command -v "$1" >/dev/null || cannot "$1 is not here"; }
needs_python() { "$python" -c "import $1" 2>/dev/null || cannot "Debian's python3 has no $1"; }
in_display() { timeout 600 xvfb-run -a -s "-screen 0 1024x768x24" "$@"; }

# shows PICTURE COLOR...: each of the colors is in the picture.
shows() {
    "$python" - "$@" <<'END'
import sys
import pygame
loaded = pygame.image.load(sys.argv[1])
picture = pygame.Surface(loaded.get_size(), 0, 32)
picture.blit(loaded, (0, 0))
for color in sys.argv[2:]:
    pixels = pygame.mask.from_threshold(picture, pygame.Color(color), (12, 12, 12, 255)).count()
    print(f"{color}: {pixels} pixels")
    if pixels < 50:
        sys.exit(f"{sys.argv[1]}: {color} is missing")
END
}

case_sdl2() {
    needs pkg-config
    pkg-config --exists sdl2 || cannot "SDL2 is not here"
    needs_python pygame
    local flags
    read -r -a flags < <(pkg-config --cflags --libs sdl2)
    cc -std=c11 -Wall -Wextra -Wpedantic -Werror -I"$project/bindings/c/include" "$project/examples/sdl2/main.c" \
        -o "$folder/sdl2" "${flags[@]}" "$library" -lm -Wl,-rpath,"${library%/*}"
    in_display "$folder/sdl2" 120 "$folder/sdl2.bmp"
    shows "$folder/sdl2.bmp" "#e0a090" "#70a070"
}

# A whole game, and its console as triangles. The colors: the console, a path in its output, the game.
case_sdl2_host() {
    needs pkg-config
    pkg-config --exists sdl2 || cannot "SDL2 is not here"
    needs_python pygame
    local flags
    read -r -a flags < <(pkg-config --cflags --libs sdl2)
    cc -std=c11 -Wall -Wextra -Wpedantic -Werror -I"$project/bindings/host/include" -I"$project/bindings/c/include" \
        "$project/examples/sdl2_host/main.c" -o "$folder/sdl2_host" "${flags[@]}" "$host" "$library" -lm \
        -Wl,-rpath,"${host%/*}:${library%/*}"
    in_display "$folder/sdl2_host" 120 "$folder/sdl2_host.bmp" | tee "$folder/sdl2_host.txt"
    grep -qx 'gravity is 2, -4' "$folder/sdl2_host.txt"  # as it was typed
    shows "$folder/sdl2_host.bmp" "#14171e" "#77bdfb" "#fabe46"
}

# The package in a copy of its folder, because building it writes files that do not belong into the checkout.
copy_package() {
    needs_python cffi
    needs_python numpy
    rm -rf -- "$folder/package"
    cp -R -- "$project/bindings/python" "$folder/package"
    export FETTLE_INCLUDE=$project/bindings/c/include
}

case_python() {
    copy_package
    cd -- "$folder/package"
    "$python" build_interface.py
    FETTLE_LIBRARY=$library PYTHONPATH=$folder/package "$python" -W error -m unittest discover tests
    FETTLE_LIBRARY=$library PYTHONPATH=$folder/package "$python" speed.py 1
}

case_python_installed() {
    copy_package
    needs_python venv
    needs_python setuptools
    rm -rf -- "$folder/venv"
    "$python" -m venv --system-site-packages "$folder/venv"
    FETTLE_LIBRARY=$library "$folder/venv/bin/pip" install --no-build-isolation --no-deps "$folder/package"
    cd /
    "$folder/venv/bin/python" -c "import fettle; fettle.World().step(1); print(fettle.version(), fettle.__file__)"
}

case_python_demo() {
    copy_package
    needs_python pygame
    cd -- "$folder/package"
    "$python" build_interface.py
    FETTLE_LIBRARY=$library PYTHONPATH=$folder/package in_display "$python" demo.py 120 "$folder/pygame.png"
    shows "$folder/pygame.png" tomato gold dimgray
}

# love_game FOLDER: a copy of a game of bindings/love with the library in it.
love_game() {
    needs love
    rm -rf -- "$folder/$1"
    mkdir -p -- "$folder/$1"
    cp -- "$project/bindings/love/$1"/*.lua "$folder/$1/"
    "$project/bindings/love/install.sh" "$library" "$project/bindings/c/include" "$folder/$1"
}

# The same for the library that hosts a whole game. The headers are in one folder, as in an installation.
love_host_game() {
    needs love
    rm -rf -- "$folder/$1" "$folder/include"
    mkdir -p -- "$folder/$1" "$folder/include"
    cp -R -- "$project"/bindings/{c,host}/include/. "$folder/include/"
    cp -- "$project/bindings/love/$1"/*.lua "$folder/$1/"
    "$project/bindings/love/install.sh" "$library" "$folder/include" "$folder/$1" "$host"
}

case_love_host() {
    love_host_game host_tests
    timeout 600 love "$folder/host_tests"
}

case_love_host_demo() {
    needs_python pygame
    love_host_game host_demo
    export XDG_DATA_HOME=$folder/love
    in_display love "$folder/host_demo" --frames 120 demo.png | tee "$folder/host_demo.txt"
    grep -qx 'gravity is 2, -4' "$folder/host_demo.txt"  # as it was typed
    shows "$folder/love/love/host_demo/demo.png" "#14171e" "#77bdfb" "#fabf47"
}

case_love() {
    love_game tests
    timeout 600 love "$folder/tests"
    timeout 600 love "$folder/tests" --love  # love.physics itself passes the same tests
}

case_love_demo() {
    needs_python pygame
    love_game demo
    export XDG_DATA_HOME=$folder/love
    in_display love "$folder/demo" --frames 120 demo.png
    shows "$folder/love/love/demo/demo.png" "#ff6347" gold skyblue
    in_display love "$folder/demo" --speed
    in_display love "$folder/demo" --speed --love
}

# love.physics beside Fettle: each scene has a row for both.
case_love_speed() {
    love_game bench
    timeout 600 love "$folder/bench" 1 | tee "$folder/love_speed.txt"
    local of_fettle of_love
    of_fettle=$(grep -c ' fettle.physics ' "$folder/love_speed.txt")
    of_love=$(grep -c ' love.physics .*; Fettle then ' "$folder/love_speed.txt")
    ((of_fettle == 10 && of_love == 10))
}

# The npm package, made from its own archive in a project that has nothing else. Nothing is downloaded for it.
web_project() {
    needs em++
    needs node
    needs npm
    "$project/tests/platforms/run.sh" package webassembly "$(dirname -- "$build")"
    rm -rf -- "$folder/web"
    mkdir -p -- "$folder/web"
    cd -- "$folder/web"
    npm pack --silent "$(dirname -- "$build")/webassembly/package"
    printf '{ "name": "empty", "private": true, "type": "module" }\n' >package.json
    npm install --offline --no-audit --no-fund ./fettle-physics-*.tgz
}

case_web() {
    web_project
    cp -- "$project"/bindings/web/tests/* .
    node --expose-gc --test package.test.mjs functions.test.mjs
    # The program of the guide, and what it prints.
    sed -n '/^```js drop.mjs$/,/^```$/{/^```/!p}' "$project/docs/guide/web.md" >drop.mjs
    sed -n '/^```text$/,/^```$/{/^```/!p}' "$project/docs/guide/web.md" >expected.txt
    node drop.mjs | diff - expected.txt
    if command -v tsc >/dev/null; then
        tsc --strict --target es2022 --module es2022 --moduleResolution node --noEmit types.ts
    else
        cannot "the tests have passed, but tsc is not here to check the types"
    fi
}

# page_shows PICTURE STEPS COLOR...: index.html of this folder in a browser shows the colors after so many steps.
page_shows() {
    local picture=$1 steps=$2 attempt
    shift 2
    # A page of modules needs a server.
    "$python" -u -m http.server --bind 127.0.0.1 0 >server.log 2>&1 &
    local server=$! port=
    # shellcheck disable=SC2064  # the number of this server
    trap "kill $server" EXIT
    until port=$(sed -n 's/.*http:\/\/127\.0\.0\.1:\([0-9]*\).*/\1/p' server.log) && [[ -n $port ]]; do sleep 0.1; done
    # Virtual time does not wait for the compilation of WebAssembly: on a busy machine the picture comes before it.
    for attempt in 1 2 3 4 5; do
        timeout 600 chromium --headless --no-sandbox --disable-gpu --user-data-dir="$folder/chromium" \
            --window-size=1000,600 --virtual-time-budget=$((20000 * attempt)) --screenshot="$picture" \
            "http://127.0.0.1:$port/index.html?steps=$steps"
        if shows "$picture" "$@"; then return; fi
    done
    return 1
}

case_web_demo() {
    needs chromium
    needs_python pygame
    web_project
    cp -- "$project"/bindings/web/demo/* .
    page_shows "$folder/web.png" 100 gold "#ff6347" "#708070"
}

# Entities of bitECS, which is from npm, with bodies of Fettle: its tests, and its page.
case_web_bitecs() {
    needs chromium
    needs_python pygame
    web_project
    npm install --no-audit --no-fund bitecs@0.4.0 || cannot "npm could not install bitecs"
    cp -- "$project"/examples/bitecs/* .
    node --test game.test.mjs
    page_shows "$folder/bitecs.png" 200 gold "#ff6347" "#708070"
}

# The other engines are from npm; without the network the table has Fettle alone.
case_web_speed() {
    web_project
    npm install --no-audit --no-fund @dimforge/rapier2d-simd-compat planck matter-js || echo "npm could not install the other engines"
    cp -- "$project"/bindings/web/bench/* .
    node main.mjs 2
}

# The pages of the guide, with the blocks that need the packages of these hosts.
case_guide() {
    [[ -x $build/bin/fettle ]] || cannot "the guide installs all of Fettle, which ./check builds"
    needs_python cffi
    needs_python numpy
    needs love
    local page
    for page in c-and-python love; do
        "$project/tests/documents/follow.sh" --hosts "docs/guide/$page.md" "$build" "$folder/guide-$page"
    done
}

"case_$1"
