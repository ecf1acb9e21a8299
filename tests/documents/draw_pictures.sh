#!/usr/bin/env bash
# Draws the pictures of every document anew. Look at them before they are committed.
#
#   draw_pictures.sh BUILD    or: cmake --build build/release --target pictures
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
cd -- "$here/../.."
for document in README.md docs/guide/*.md; do
    grep '<!-- test: picture' "$document" | grep -qv 'picture kept' || continue
    "$here/follow.sh" --draw "$document" "$1" "$1/documents/draw"
done
