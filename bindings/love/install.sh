#!/usr/bin/env bash
# Puts the physics library into the folder of a LÖVE game: the modules, the library, and its declarations.
#
#   install.sh LIBRARY INCLUDE GAME    LIBRARY is libfettle_physics_c.so, INCLUDE the folder of fettle_physics.h
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
library=$1 include=$2 game=$3
mkdir -p -- "$game/fettle"
cp -- "$here"/fettle/*.lua "$game/fettle/"
cp -L -- "$library" "$game/fettle/libfettle_physics_c.so"
# As fettle/physics_c/basics.h says: without comments, lines that begin with #, and the two words.
{
    echo 'return [['
    sed -nE 's|^#include <(fettle/physics_c/.*)>|\1|p' "$include/fettle_physics.h" | while read -r header; do cat -- "$include/$header"; done |
        awk '{
            line = $0
            out = ""
            while (line != "") {
                if (comment) {
                    end = index(line, "*/")
                    if (!end) break
                    line = substr(line, end + 2)
                    comment = 0
                } else {
                    begin = index(line, "/*")
                    if (!begin) { out = out line; break }
                    out = out substr(line, 1, begin - 1)
                    line = substr(line, begin + 2)
                    comment = 1
                }
            }
            if (out !~ /^#/ && out !~ /^FETTLE_PHYSICS_C_(BEGIN|END)/ && out !~ /^ *$/) print out
        }'
    echo ']]'
} >"$game/fettle/declarations.lua"
