#!/usr/bin/env bash
# Follows a document as a new user does: makes a fresh checkout and an empty home, writes every file that the document shows,
# runs every command, and compares the whole output with what the document shows. A block that cannot be tested is a failure.
#
#   follow.sh DOCUMENT BUILD FOLDER    DOCUMENT is absolute or relative to the project; BUILD is a build folder in which everything is
#                                      built; FOLDER is where checkout and home are made
#   follow.sh --draw DOCUMENT BUILD FOLDER    the same, and writes the pictures of the document in place of comparing them
#   follow.sh --full DOCUMENT BUILD FOLDER    runs only the blocks marked "full", in the checkout that this file is part of
#   follow.sh --hosts DOCUMENT BUILD FOLDER   also runs the blocks marked "hosts", which need the packages of `check --hosts`
#   follow.sh --prepare FOLDER    makes the checkout FOLDER. Where FETTLE_PREPARED names it, the other forms link to its files, which is
#                                 quicker than a copy: a page may replace these files, but not write into them
#
# How each kind of block is tested, and what the marks in comments mean, is in docs/design/testing.md.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
source "$here/blocks.sh"
sources=$(cd -- "$here/../.." && pwd -P)
full=0 draw=0 hosts=0 limit=600  # seconds

# The files of the repository, with changes that are not committed.
make_checkout() {
    local checkout=$1
    mkdir -- "$checkout"
    if git -C "$sources" rev-parse --git-dir >/dev/null 2>&1; then
        git -C "$sources" ls-files -z --cached --others --exclude-standard
    else
        (cd -- "$sources" && find . -path ./build -prune -o -type f -print0)
    fi | while IFS= read -r -d '' file; do
        if [[ -e $sources/$file ]]; then printf '%s\0' "$file"; fi
    done | tar -C "$sources" --null -T - -cf - | tar -C "$checkout" -xf -
}

if [[ ${1:-} == --draw ]]; then draw=1; shift; fi
if [[ ${1:-} == --full ]]; then full=1 limit=3600; shift; fi
if [[ ${1:-} == --hosts ]]; then hosts=1; shift; fi
if [[ ${1:-} == --prepare ]]; then
    rm -rf -- "$2"
    mkdir -p -- "$(dirname -- "$2")"
    make_checkout "$2"
    touch -- "$2.made"
    exit
fi
document=$1 folder=$3
finished=$(cd -- "$2" && pwd -P)
[[ -x $finished/bin/fettle ]] || { echo "$finished/bin/fettle is not built"; exit 1; }
if [[ $document == /* ]]; then where=$document; else where=$sources/$document; fi
read_blocks "$where"

# --- The checkout ---------------------------------------------------------------------------------------------------------

rm -rf -- "$folder"
# Home folders have no spaces in their names, and documents need not quote them.
if [[ $folder == *[[:space:]]* ]]; then
    folder=$(mktemp -d "${TMPDIR:-/tmp}/fettle-documents.XXXXXX")
    trap 'rm -rf -- "$folder"' EXIT
fi
mkdir -p -- "$folder/home"
folder=$(cd -- "$folder" && pwd -P)
terminal=$folder/terminal
checkout=$folder/fettle

# The terminal: a new user's environment, and the programs that replace those which would build and test everything.
environment=(
    env -i HOME="$folder/home" USER=reader TERM=dumb LANG=C.UTF-8 TMPDIR="${TMPDIR:-/tmp}"
    PATH="$here/stand-ins:$PATH" FETTLE_CHECKOUT="$checkout" FETTLE_FINISHED="$finished" FETTLE_PATH="$PATH")
if command -v ccache >/dev/null; then
    environment+=(CCACHE_DIR="$(ccache -k cache_dir)" CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
if ((full)); then
    environment=(env)
    checkout=$sources
elif [[ -n ${FETTLE_PREPARED:-} ]]; then
    cp -al -- "$FETTLE_PREPARED" "$checkout" 2>/dev/null || { rm -rf -- "$checkout" && cp -a -- "$FETTLE_PREPARED" "$checkout"; }
    # `fettle docs` writes into these files.
    if [[ -e $checkout/docs/reference ]]; then
        rm -r -- "$checkout/docs/reference"
        cp -a -- "$FETTLE_PREPARED/docs/reference" "$checkout/docs/"
    fi
else
    make_checkout "$checkout"
fi
printf 'cd %q\n' "$checkout" >"$terminal"

# in_terminal COMMANDS: runs them in the same terminal as the commands before; their output goes to $printed.
in_terminal() {
    local status=0
    # shellcheck disable=SC2016
    printed=$("${environment[@]}" timeout "$limit" bash -ec '
        source "$1"
        trap '\''status=$?; { export -p; printf "cd %q\n" "$PWD"; } >"$1"; exit $status'\'' EXIT
        eval "$2"' terminal "$terminal" "$1" 2>&1 </dev/null && printf .) || status=$?
    printed=${printed%.}
    return "$status"
}

# --- The test of each block -----------------------------------------------------------------------------------------------

fail() {
    printf '%s:%s: %s\n' "$document" "${block_line[i]}" "$*"
    exit 1
}

run_commands() {
    in_terminal "$1" || fail "these commands fail:
$1--- they print:
$printed"
    has_output=1
}

write_file() {
    # shellcheck disable=SC2016
    in_terminal 'mkdir -p -- "$(dirname -- "'"${block_file[i]}"'")"; pwd' || fail "$printed"
    rm -f -- "${printed%$'\n'}/${block_file[i]}"  # perhaps linked to the prepared checkout
    printf '%s' "${block_text[i]}" >"${printed%$'\n'}/${block_file[i]}"
}

# The only parts of an output that may differ from the document: the time of day, the reader's home, which it calls ~, and the
# number in the name of a game's folder there, which is made from the place of the game.
without_clock() { sed -E -e 's/\b[0-2][0-9]:[0-5][0-9]:[0-5][0-9]\b/HH:MM:SS/g' -e "s|$folder/home|~|g" -e 's|(~/[a-z./]+/fettle/[a-z]+)-[0-9a-f]{8}/|\1-NUMBER/|g'; }

compare_output() {
    ((has_output)) || fail "this output belongs to no commands"
    diff -u --label "what the document shows" --label "what is printed" \
        <(without_clock <<<"$1") <(without_clock <<<"${printed%$'\n'}") || fail "the output is another one"
    has_output=0
}

# Each line that begins with the prompt is typed before the step that the mark names for it, or one step later than the last.
play_console() {
    local game steps=() step=0 line typed=() words
    [[ ${block_mark[i]} =~ ^console\ (fresh\ )?([^ ]+)\ at\ ([0-9 ]+)$ ]] ||
        fail "a console needs a mark: <!-- test: console GAME at STEP STEP ... -->"
    game=${BASH_REMATCH[2]}
    read -r -a steps <<<"${BASH_REMATCH[3]}"
    if [[ -n ${BASH_REMATCH[1]} ]]; then in_terminal "rm -rf -- $game/.fettle"; fi
    while IFS= read -r line; do
        [[ $line == '› '* ]] || continue
        step=${steps[0]:-$((step + 1))}
        steps=("${steps[@]:1}")
        typed+=(--console "$step:${line#'› '}")
    done <<<"${block_text[i]}"
    ((${#typed[@]})) || fail "nothing is typed here"
    printf -v words ' %q' --headless --steps "$((step + 1))" "${typed[@]}"
    console_game=$game console_words=$words
    run_commands "$(printf '%q' "$finished/bin/fettle") run $game$words"
    compare_output "${block_text[i]%$'\n'}"
}

# --- Pictures -------------------------------------------------------------------------------------------------------------

# Pictures are smaller than a window usually is, so that a page shows their texts in full size.
picture_size='--eval "view.window.size = vec(960, 600)"'

# draw_picture: makes the picture that the document shows as its mark says, and compares it with the one in the repository,
# or writes that one.
draw_picture() {
    local mark=${block_mark[i]} kept drawn=$folder/drawn.${block_file[i]##*.} words pictures
    kept=$(cd -- "$(dirname -- "$where")" && realpath -m -- "${block_file[i]}")
    rm -f -- "$drawn"
    case $mark in
        # In a copy, so that the edits of the block before are not there twice.
        'picture console'*)
            in_terminal "rm -rf '$folder/copy' && cp -r '$console_game' '$folder/copy' && rm -rf '$folder/copy/.fettle'" || fail "$printed"
            printf -v words '%q run %q %s --eval console.open=true %s' \
                "$finished/bin/fettle" "$folder/copy" "$console_words" "${mark#picture console}"
            ;;
        'picture session '*) words= ;;
        'picture made '*)
            in_terminal "test -s ${mark#picture made } && pwd" || fail "the commands before wrote no ${mark#picture made }"
            words=
            cp -- "${printed%$'\n'}/${mark#picture made }" "$drawn"
            ;;
        'picture moment '*)
            # The file that `share` wrote in the console block before.
            [[ $mark =~ ^picture\ moment\ ([A-Za-z0-9_-]+)(.*)$ ]] || fail "no such mark: test: $mark"
            printf -v words '%q run ~/.local/share/fettle/*/moments/%q.fettle --headless --steps 1%s' \
                "$finished/bin/fettle" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}"
            ;;
        picture\ *\ at\ *)
            [[ $mark =~ ^picture\ ([^ ]+)\ at\ ([0-9]+)(.*)$ ]] || fail "no such mark: test: $mark"
            # A page may begin with a picture of what it makes.
            if [[ -z ${drawing_last:-} ]] && ! in_terminal "test -e '${BASH_REMATCH[1]}'"; then
                last_pictures+=("$i")
                return
            fi
            printf -v words '%q run %q --headless --steps %s' "$finished/bin/fettle" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}"
            words+=${BASH_REMATCH[3]}
            ;;
        'picture kept') [[ -s $kept ]] || fail "there is no $kept"; return ;;
        *) fail "a picture needs a mark that says how it is drawn: <!-- test: picture GAME at STEP -->" ;;
    esac
    if [[ $mark == 'picture session '* ]]; then
        # A moving picture is not compared, so nothing is drawn.
        pictures=("$folder/frames" "$drawn")
        if ((!draw)) && [[ $drawn == *.webp ]]; then pictures=(); fi
        "$here/draw_session.sh" "${mark#picture session }" "$checkout" "$finished" ${pictures[@]+"${pictures[@]}"} ||
            fail "the session went wrong"
    elif [[ -n $words ]]; then
        printf -v words "LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s '-screen 0 1280x800x24 -noreset' %s %s --screenshot %q" "$words" "$picture_size" "$drawn"
        run_commands "$words"
    fi
    [[ -s $drawn || $drawn == *.webp ]] || fail "no picture was drawn"
    if ((draw)); then
        if [[ -s $drawn ]]; then mkdir -p -- "$(dirname -- "$kept")" && cp -- "$drawn" "$kept"; fi
        return
    fi
    [[ -s $kept ]] || fail "there is no picture $kept yet: draw it with follow.sh --draw, and look at it"
    if [[ $kept == *.webp ]]; then
        # A page with the picture must load quickly.
        (($(stat -c %s -- "$kept") <= 3000000)) || fail "$kept has more than 3 MB"
    elif [[ $kept == *.svg ]]; then
        cmp -- "$kept" "$drawn" || fail "look at both pictures; follow.sh --draw writes the new one"
    else
        "$finished/bin/fettle_pictures" compare "$kept" "$drawn" || fail "look at both pictures; follow.sh --draw writes the new one"
    fi
}

tested=0 has_output=0 printed= console_words= console_game= last_pictures=()
for i in "${!block_kind[@]}"; do
    kind=${block_kind[i]} file=${block_file[i]} mark=${block_mark[i]}
    if [[ $mark == full ]]; then
        ((full)) || continue
    elif ((full)); then
        continue
    fi
    if [[ $mark == foreign ]]; then continue; fi
    if [[ $mark == hosts* ]]; then
        ((hosts)) || continue
        mark=${mark#hosts}
        mark=${mark# }
    fi
    case $kind in
        sh) run_commands "${block_text[i]}" ;;
        text) compare_output "${block_text[i]%$'\n'}" ;;
        console) play_console ;;
        picture) draw_picture ;;
        cpp | c | cmake | json | lua | python | glsl)
            [[ -n $file ]] || fail "a block of $kind needs the name of its file behind the language"
            write_file
            ;;
        '') fail "this block has no language, so that no test can run it" ;;
        indented) fail "an indented block has no language, so that no test can run it: fence it" ;;
        html) fail "no test can run a block of HTML: fence it" ;;
        open) fail "this block has no end" ;;
        *) fail "no test can run a block of $kind" ;;
    esac
    if [[ $mark == run\ * ]]; then run_commands "${mark#run }"; fi
    case $mark in
        '' | full | run\ * | console\ * | picture\ *) ;;
        *) fail "no such mark: test: $mark" ;;
    esac
    tested=$((tested + 1))
done
drawing_last=1
for i in ${last_pictures[@]+"${last_pictures[@]}"}; do draw_picture; done
if [[ -n ${FETTLE_PREPARED:-} ]]; then
    written=$(find "$FETTLE_PREPARED" -newer "$FETTLE_PREPARED.made" -type f)
    [[ -z $written ]] || { printf '%s: its commands write into files that all pages share: %s\n' "$document" "$written"; exit 1; }
fi
printf '%s: %d blocks, all as they stand\n' "$document" "$tested"
# Forty checkouts would be written to the disk while other tests run. That of a page with an error stays.
if [[ -n ${FETTLE_PREPARED:-} ]]; then rm -rf -- "$folder"; fi
