# Sourced by `play` and `check`: what a bare machine needs before anything can be built, and how the
# presets are configured and built, with progress that suits a terminal as well as a log.
# shellcheck shell=bash

fettle_root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)

say() { printf '%s: %s\n' "${0##*/}" "$*"; }
complain() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }

# with_progress HANDLER: calls HANDLER with each line of its input. A handler may call progress and pass_on.
with_progress() {
    local handler=$1 line terminal=0 drawn=0 current='' last_tenth='' began=$SECONDS
    if [[ -t 1 ]]; then terminal=1; fi
    while IFS= read -r line || [[ -n $line ]]; do "$handler" "$line"; done
    wipe
}

# progress WHAT DONE ALL [TEXT]: how far the work called WHAT is, and how long the rest will take if it goes on like that.
# A bar on a terminal, elsewhere a plain line for every tenth part.
progress() {
    local what=$1 done=$2 all=$3 text=${4:-"$2 of $3"} tenth elapsed left
    if [[ $what != "$current" ]]; then current=$what last_tenth='' began=$SECONDS; fi
    tenth=$((10 * done / all))
    elapsed=$((SECONDS - began))
    # The first moments say little about the rest.
    left=$((done ? elapsed * (all - done) / done : 0))
    if ((elapsed >= 5 && left)); then text+=", about $(duration $left) left"; fi
    if ((terminal)); then
        printf '\r\033[K%s: %s [%.*s%.*s] %s' "${0##*/}" "$what" "$tenth" '##########' "$((10 - tenth))" '----------' "$text"
        drawn=1
    elif [[ $tenth != "$last_tenth" ]]; then
        printf '%s: %s, %s\n' "${0##*/}" "$what" "$text"
    fi
    last_tenth=$tenth
}

# duration SECONDS, as a person would say it.
duration() {
    if (($1 >= 90)); then echo "$((($1 + 30) / 60)) min"; else echo "$1 s"; fi
}

wipe() {
    if ((drawn)); then printf '\r\033[K'; fi
    drawn=0
}

pass_on() {
    wipe
    printf '%s\n' "$1"
}

# --- Packages -------------------------------------------------------------------------------------

# The lines of cmake/packages.txt for these purposes, each as "NAME|ALTERNATIVE|..." or "NAME?".
packages_for() {
    local purposes=" $* " purpose names
    while read -r purpose names; do
        if [[ $purposes == *" $purpose "* ]]; then printf '%s\n' "${names// /}"; fi
    done < <(sed 's/#.*//; /^[[:space:]]*$/d' "$fettle_root/cmake/packages.txt") | sort -u
}

# Prints those of the given lines for which no alternative is installed.
not_installed() {
    local line name installed
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p')
    for line in "$@"; do
        for name in ${line//[|?]/ }; do
            grep -qxF -- "$name" <<<"$installed" && continue 2
        done
        printf '%s\n' "$line"
    done
}

# What has to be installed for these purposes.
missing_packages() {
    local lines missing
    mapfile -t lines < <(packages_for "$@")
    mapfile -t missing < <(not_installed "${lines[@]}")
    installable "${missing[@]}"
}

known_to_apt() { apt-cache show -- "$1" >/dev/null 2>&1; }

# What to install for each line: the first alternative that apt knows. Where it knows none, the first one,
# or nothing for an optional line. Apt is asked once for all: it reads all its lists each time, where it may not keep them.
installable() {
    local line name known
    (($#)) || return 0
    # shellcheck disable=SC2048,SC2086
    known=$(apt-cache show -- ${*//[|?]/ } 2>/dev/null | sed -n 's/^Package: //p' | tr '\n' ' ') || true
    for line in "$@"; do
        for name in ${line//[|?]/ }; do
            if [[ " $known" == *" $name "* ]]; then
                printf '%s\n' "$name"
                continue 2
            fi
        done
        [[ $line == *\? ]] || printf '%s\n' "${line%%|*}"
    done
}

# Reads apt's status lines (KIND:PACKAGE:PERCENT:TEXT).
apt_progress() { with_progress apt_line; }
apt_line() {
    local kind rest percent
    IFS=: read -r kind _ percent rest <<<"$1"
    percent=${percent%%.*}
    case $kind in
        dlstatus) progress "downloading packages" "$percent" 100 "$percent %" ;;
        pmstatus) progress "installing packages" "$percent" 100 "$percent %" ;;
    esac
}

is_root() { [[ $(id -u) == 0 ]]; }

may_install() { is_root || { command -v sudo >/dev/null && sudo -n true 2>/dev/null; }; }

# Runs apt-get as root with its own output in a file and its progress as plain lines.
run_apt() {
    local log=$1 status=0
    shift
    local as_root=()
    is_root || as_root=(sudo -n)
    # Apt closes the file descriptor of its status before it starts dpkg. If that were the standard output, a
    # script of a package that prints would fail. The inner shell opens descriptor 3: sudo passes on only 0 to 2.
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive sh -c 'exec apt-get "$@" 3>&1 >&2' apt-get \
        -o APT::Status-Fd=3 -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 -y \
        --no-install-recommends "$@" </dev/null 2>>"$log" | tee -a "$log" | apt_progress || status=$?
    return "$status"
}

# Makes sure that the packages for these purposes are there. Does not touch the network when they are.
# Exits with 2 when they are not and this user may not install them.
ensure_packages() {
    local names
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        mapfile -t names < <(packages_for "$@")
        say "not a Debian; these packages, under the names used here, should be there: ${names[*]}"
        return 0
    fi
    mapfile -t names < <(missing_packages "$@")
    ((${#names[@]})) || return 0

    if ! may_install; then
        complain "missing packages: ${names[*]}"
        complain "install them with this line, then run ${0##*/} again:"
        printf '    sudo apt-get update && sudo apt-get install -y --no-install-recommends %s\n' \
            "${names[*]}" >&2
        exit 2
    fi

    local log updated=0
    log=$(mktemp "${TMPDIR:-/tmp}/fettle-apt.XXXXXX")
    if ! known_to_apt "${names[0]}"; then
        say "reading the package lists"
        run_apt "$log" update || complain "apt-get update failed; going on with the lists there are"
        updated=1
        mapfile -t names < <(missing_packages "$@")
    fi
    say "installing ${#names[@]} missing packages: ${names[*]}"
    if ! run_apt "$log" install "${names[@]}"; then
        # Old package lists name versions that the mirror no longer has.
        if ((updated)) || ! run_apt "$log" update || ! run_apt "$log" install "${names[@]}"; then
            grep -E '^(E:|W:|dpkg: error|/var/lib/dpkg/)' "$log" >&2 || tail -n 20 "$log" >&2
            complain "apt-get could not install them; its whole output is in $log"
            exit 2
        fi
    fi
    rm -f -- "$log"
}

# ensure_packages_and_later PURPOSE ... -- PURPOSE ...: as ensure_packages, but those of the second purposes are installed in
# the background, while the compiler works: an installation mostly waits for the network and the disk. later_packages waits
# for it. A user who may not install packages is told all that are missing at once.
ensure_packages_and_later() {
    local now=()
    while [[ $1 != -- ]]; do now+=("$1"); shift; done
    shift
    if ! command -v apt-get >/dev/null || ! may_install; then
        ensure_packages "${now[@]}" "$@"
        return
    fi
    ensure_packages "${now[@]}"
    local names
    mapfile -t names < <(missing_packages "$@")
    ((${#names[@]})) || return 0
    say "installing ${#names[@]} missing packages: ${names[*]}"
    later_log=$(mktemp "${TMPDIR:-/tmp}/fettle-later.XXXXXX")
    ensure_packages "$@" >"$later_log" 2>&1 &
    later_job=$!
    trap later_packages EXIT
}

# Waits for what ensure_packages_and_later has started, and prints how far it is. Prints its whole output and returns its
# status if it failed.
later_packages() {
    local status=0
    trap - EXIT
    [[ -n ${later_job:-} ]] || return 0
    # What it has printed until then is no longer true once it has ended.
    if kill -0 "$later_job" 2>/dev/null; then tail -n 1 -f --pid="$later_job" -- "$later_log"; fi
    wait "$later_job" || status=$?
    ((status == 0)) || cat -- "$later_log" >&2
    rm -f -- "$later_log"
    later_job=
    return "$status"
}

# --- Building -------------------------------------------------------------------------------------

jobs() { nproc 2>/dev/null || echo 2; }

# configure PRESET [CMAKE-ARGUMENT ...]
# A build folder that was made for another checkout or by another generator is made anew; one of build_core gets all parts.
configure() {
    local preset=$1 folder=$fettle_root/build/$1 fresh=() whole=()
    shift
    if [[ -e $folder/CMakeCache.txt ]] &&
        ! { grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$fettle_root" "$folder/CMakeCache.txt" &&
            grep -qxF "CMAKE_GENERATOR:INTERNAL=Ninja" "$folder/CMakeCache.txt"; }; then
        say "build/$preset belongs to another checkout or generator; configuring it anew"
        fresh=(--fresh)
    fi
    mkdir -p -- "$folder"
    if grep -sqx "FETTLE_PARTS:[A-Z]*=$core_part" "$folder/CMakeCache.txt"; then whole=(-U FETTLE_PARTS); fi
    if ! (cd -- "$fettle_root" && cmake --preset "$preset" "${fresh[@]}" "${whole[@]}" "$@") \
        >"$folder/configure.log" 2>&1 </dev/null; then
        cat -- "$folder/configure.log" >&2
        complain "configuring the preset $preset failed"
        return 1
    fi
}

# Turns ninja's lines into progress, and passes every complaint on.
build_progress() { with_progress ninja_line; }
ninja_line() {
    if [[ $1 =~ ^\[([0-9]+)/([0-9]+)\]\  ]]; then
        if ((BASH_REMATCH[2] > 2)); then progress "building" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}"; fi
    elif [[ ! $1 =~ ^(ninja: (no work to do|Entering directory)|-- (Configuring|Generating|Build files)) ]]; then
        pass_on "$1"
    fi
}

# The command that starts builds and tests; `env` starts them unchanged.
launcher=(env)

# build_preset PRESET [TARGET ...]: everything when no target is named.
build_preset() {
    local preset=$1 targets=()
    shift
    (($#)) && targets=(--target "$@")
    "${launcher[@]}" cmake --build "$fettle_root/build/$preset" -j "$(jobs)" "${targets[@]}" \
        2>&1 </dev/null | build_progress
}

# build_core PRESET [CMAKE-ARGUMENT ...]: while ensure_packages_and_later still installs packages, builds the libraries that
# need none of them, half of the program. Only for the first build: later there is little to build.
core_part=physics_module
build_core() {
    local preset=$1
    shift
    [[ -n ${later_job:-} && ! -e $fettle_root/build/$preset/CMakeCache.txt ]] || return 0
    say "building the libraries that need none of the packages that are being installed"
    configure "$preset" "$@" -DFETTLE_PARTS=$core_part -DFETTLE_BUILD_TESTS=OFF -DFETTLE_BUILD_BENCH=OFF &&
        build_preset "$preset" "fettle_$core_part"
}
