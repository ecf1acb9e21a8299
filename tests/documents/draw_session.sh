#!/usr/bin/env bash
# Plays a session and makes a moving picture of it.
#
#   draw_session.sh NAME PROJECT BUILD FRAMES PICTURE
#   draw_session.sh NAME PROJECT BUILD                   only plays it, and draws nothing
#
# NAME is that of a file in tests/pictures/sessions; FRAMES is a folder that is made anew. PICTURE ends in .webp, or in .png for the last
# frame only. Without the program img2webp (Debian: webp) only the frames are made.
set -euo pipefail
name=$1 project=$2 finished=$3 frames=${4:-} picture=${5:-}
rate=20  # frames a second, as in tests/pictures/play.h

play() {
    LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s '-screen 0 1280x800x24 -noreset' \
        "$finished/bin/fettle_pictures" session "$project/tests/pictures/sessions/$name.txt" "$project" "$@"
}

if [[ $picture != *.webp ]]; then
    play ${picture:+"$picture"}
    exit
fi
rm -rf -- "$frames"
play "$frames"
command -v img2webp >/dev/null || { echo "img2webp is not here (Debian: webp): the frames are in $frames"; exit 0; }
img2webp -loop 0 -min_size -lossy -q 70 -m 4 -d $((1000 / rate)) "$frames"/*.png -o "$picture" >/dev/null
