#!/usr/bin/env bash
# Builds the reference of the public headers. Each warning of Doxygen is a failure: a public member without a comment, the name of
# a parameter that does not exist. Exit status 77: Doxygen is not here.
#
#   reference.sh FOLDER [HEADERS]    the pages are in FOLDER/html; HEADERS: other headers than those of docs/doxygen/Doxyfile
set -euo pipefail
if (($# < 1 || $# > 2)) || [[ $1 == -* ]]; then
    sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
    exit 2
fi
command -v doxygen >/dev/null || { echo "Doxygen is not here"; exit 77; }
mkdir -p -- "$1"
folder=$(cd -- "$1" && pwd -P)
headers=${2:+$(cd -- "$2" && pwd -P)}
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
perl -c docs/doxygen/filter.pl 2>/dev/null || { echo "docs/doxygen/filter.pl has an error"; exit 1; }  # Doxygen does not say so
{
    cat docs/doxygen/Doxyfile
    printf 'OUTPUT_DIRECTORY = "%s"\n' "$folder"
    if [[ -n $headers ]]; then printf 'INPUT = "%s"\n' "$headers"; fi
} | doxygen - 2>&1 | sort -u | sed "s|^$PWD/||"
