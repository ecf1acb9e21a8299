#!/usr/bin/env bash
# Follows the guide to hosting as a reader would: writes every file it shows, runs every command, and looks for every
# line of output it promises. A block says what it is behind its fence:
#
#   ```cpp near/main.cpp    a file         ```sh    commands, with $PREFIX where Fettle is installed
#   ```text                 what the commands before it print: each line in this order, somewhere in it
#   ```                     something to look at
#
#   guide.sh GUIDE PREFIX LIBRARIES FOLDER
set -euo pipefail
guide=$1 export_prefix=$2 libraries=$3 folder=$4
export PREFIX=$export_prefix PATH="$export_prefix/bin:$PATH" LD_LIBRARY_PATH="$libraries" CMAKE_GENERATOR=Ninja
rm -rf -- "$folder"
mkdir -p -- "$folder"
cd -- "$folder"
unset DISPLAY WAYLAND_DISPLAY

files=0 commands=0 promises=0 kind='' name='' number=0 start=0
block=() said=''
finish() {
    local line rest
    case $kind in
        sh)
            printf '%s\n' "set -e" "${block[@]}" >commands.sh
            if ! said=$(bash commands.sh 2>&1 </dev/null); then
                printf '%s\nguide:%s: these commands fail\n' "$said" "$start"
                exit 1
            fi
            commands=$((commands + ${#block[@]}))
            ;;
        text)
            rest=$said
            for line in "${block[@]}"; do
                if [[ $rest != *"$line"* ]]; then
                    printf '%s\nguide:%s: this is nowhere in the output: %s\n' "$said" "$start" "$line"
                    exit 1
                fi
                rest=${rest#*"$line"}
                promises=$((promises + 1))
            done
            ;;
        '') ;;
        *)
            if [[ -z $name ]]; then
                printf 'guide:%s: a block of %s that is no file: nobody tests it\n' "$start" "$kind"
                exit 1
            fi
            mkdir -p -- "$(dirname -- "$name")"
            printf '%s\n' "${block[@]}" >"$name"
            files=$((files + 1))
            ;;
    esac
}

inside=0
while IFS= read -r line; do
    number=$((number + 1))
    if [[ $line == '```'* ]]; then
        if ((inside)); then
            finish
            inside=0
        else
            inside=1 start=$number block=()
            read -r kind name <<<"${line#'```'}" || true
        fi
    elif ((inside)); then
        block+=("$line")
    fi
done <"$guide"
printf 'the guide holds: %d files, %d commands, %d lines of output\n' "$files" "$commands" "$promises"
