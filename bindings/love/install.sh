#!/usr/bin/env bash
# Puts Fettle into the folder of a LÖVE game: the modules, the library, and its declarations.
#
#   install.sh LIBRARY INCLUDE GAME [HOST]    LIBRARY is libfettle_physics_c.so, INCLUDE the folder of fettle_physics.h. HOST is
#                                             libfettle_host.so, for `fettle.host` and `fettle.console`, which need fettle_host.h
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
library=$1 include=$2 game=$3 host=${4:-}

# declarations HEADER NAME: prints the headers of fettle/NAME that HEADER includes, as LuaJIT reads them. basics.h says what must be
# left out: comments, lines that begin with #, and the words FETTLE_..._BEGIN and FETTLE_..._END.
declarations() {
    echo 'return [['
    sed -nE "s|^#include <(fettle/${2}/.*)>|\1|p" "$include/$1" | while read -r header; do cat -- "$include/$header"; done |
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
            if (out !~ /^#/ && out !~ /^FETTLE_[A-Z_]+_(BEGIN|END)/ && out !~ /^ *$/) print out
        }'
    echo ']]'
}

mkdir -p -- "$game/fettle"
cp -- "$here"/fettle/*.lua "$game/fettle/"
cp -L -- "$library" "$game/fettle/libfettle_physics_c.so"
declarations fettle_physics.h physics_c >"$game/fettle/declarations.lua"
if [[ -n $host ]]; then
    cp -L -- "$host" "$game/fettle/libfettle_host.so"
    declarations fettle_host.h host >"$game/fettle/host_declarations.lua"
fi
