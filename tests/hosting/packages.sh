#!/usr/bin/env bash
# Makes the Debian packages and installs them on a minimal Debian. Tests that their dependencies are complete, that an installed
# game runs, that another program can be built with only these packages and a compiler, and that removing them leaves no file.
#
#   packages.sh BUILD [FOLDER]    BUILD: a build folder of the shared preset; FOLDER: for the minimal Debian (500 MB)
#
# Needs root, and the packages dpkg-dev and debootstrap. Exit status 77: the test cannot run here.
set -euo pipefail
sources=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
build=$(cd -- "$1" && pwd -P)
folder=${2:-$build/packages}
mkdir -p -- "$folder"
folder=$(cd -- "$folder" && pwd -P)

cannot() { printf '%s\n' "$*"; exit 77; }
for tool in cpack dpkg-shlibdeps debootstrap chroot; do
    command -v "$tool" >/dev/null || cannot "$tool is not here"
done
((EUID == 0)) || cannot "only root makes a bare Debian"
mount --bind "$folder" "$folder" 2>/dev/null && umount "$folder" || cannot "nothing can be mounted here"

rm -f -- "$build"/*.deb
(cd -- "$build" && cpack -G DEB >cpack.log 2>&1) || { cat -- "$build/cpack.log"; exit 1; }
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
packages=("$build"/fettle_"$version"_*.deb "$build"/fettle-dev_"$version"_*.deb)
python=$build/python3-fettle_${version}_all.deb  # where cffi was there
if [[ -e $python ]]; then packages+=("$python"); else echo "python3-fettle was not made: it needs cffi, and the shared libraries"; fi
for package in "${packages[@]}"; do
    dpkg-deb --show --showformat '${Package} ${Version}, ${Installed-Size} kB; depends on ${Depends}\n' "$package"
    if command -v lintian >/dev/null; then lintian --fail-on error --tag-display-limit 0 "$package"; fi
done

# --- A minimal Debian, made once and copied -----------------------------------------------------------------------------
codename=$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-}")
[[ -n $codename ]] || cannot "the name of this Debian is unknown"
bare=${FETTLE_BARE_DEBIAN:-$folder/$codename}
if [[ -z ${FETTLE_BARE_DEBIAN:-} && ! -e $bare/.ready ]]; then
    mirror=$({ cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null || true; } |
        sed -nE '/security/d; s/^deb +(\[[^]]*\] +)?([^ ]+) .*/\2/p' | head -n 1)
    [[ -n $mirror ]] || mirror=$(sed -nE '/security/d; s/^URIs: *([^ ]+).*/\1/p' /etc/apt/sources.list.d/*.sources | head -n 1)
    rm -rf --one-file-system -- "$bare"
    script=()
    [[ -e /usr/share/debootstrap/scripts/$codename ]] || script=(/usr/share/debootstrap/scripts/sid)
    debootstrap --variant=minbase "$codename" "$bare" "$mirror" "${script[@]}" >"$folder/debootstrap.log" 2>&1 ||
        { tail -n 5 "$folder/debootstrap.log"; cannot "no bare $codename from $mirror"; }
    cp /etc/resolv.conf /etc/hosts "$bare/etc/"
    for file in /etc/apt/apt.conf.d/*; do
        if grep -qi proxy "$file"; then cp "$file" "$bare/etc/apt/apt.conf.d/"; fi
    done
    touch "$bare/.ready"
fi
root=$(mktemp -d "$folder/root.XXXXXX")
leave() {
    local point
    for point in dev proc; do
        if mountpoint -q "$root/$point"; then umount -l "$root/$point"; fi
    done
    rm -rf --one-file-system -- "$root"
}
trap leave EXIT
cp -a "$bare/." "$root/"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
inside() {
    env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
        http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" chroot "$root" "$@" </dev/null
}
somebody() { inside setpriv --reuid=nobody --regid=nogroup --clear-groups env HOME=/tmp "$@"; }
quietly() { "$@" >"$folder/apt.log" 2>&1 || { tail -n 20 "$folder/apt.log"; exit 1; }; }
expect() {
    local wanted=$1 said
    shift
    said=$("$@" 2>&1) || { printf '%s\nfailed: %s\n' "$said" "$*"; exit 1; }
    [[ $said =~ $wanted ]] || { printf '%s\nexpected %s of: %s\n' "$said" "$wanted" "$*"; exit 1; }
    printf '%s\n' "$said"
}

# --- Running ----------------------------------------------------------------------------------------------------------------
mkdir -- "$root/packages"
cp -- "${packages[@]}" "$root/packages/"
inside apt-get -o APT::Update::Error-Mode=any update >"$folder/apt.log" 2>&1 || cannot "no packages can be fetched"
inside dpkg-query -W -f '${Package}\n' | sort >"$folder/before"
quietly inside apt-get install -y --no-install-recommends "/packages/$(basename -- "${packages[0]}")"
installed=$(inside dpkg-query -W -f '${Package}\n' | sort | comm -13 "$folder/before" -)
printf 'installed with it: %s\n' "$(paste -sd ' ' <<<"$installed")"
if grep -E -- '-dev$' <<<"$installed"; then echo "what runs needs no headers"; exit 1; fi
expect "^fettle $version" somebody fettle --version
expect '[0-9a-f]{16}' somebody fettle run --headless --steps 60 --hash
for game in "$root"/usr/share/fettle/scripts/*/main.lua; do
    game=${game#"$root"}
    expect 'at[[:space:]]+29' somebody fettle run "${game%/main.lua}" --headless --steps 60 --at '30:print("at", time.step)'
done
expect 'The guide: /usr/share/doc/fettle/guide/README.md' somebody fettle --help
expect 'physics' somebody fettle run --headless --steps 2 --module physics --eval 'print(modules.physics.file)'

# --- Building ----------------------------------------------------------------------------------------------------------------
quietly inside apt-get install -y --no-install-recommends "/packages/$(basename -- "${packages[1]}")" g++ cmake make pkgconf
cp -a "$sources/examples" "$root/examples"
expect 'found and built' inside sh -c 'cmake -S /examples/bare -B /built >/built.log 2>&1 && cmake --build /built >>/built.log 2>&1 ||
    { cat /built.log; exit 1; }; echo found and built'
expect 'the ball hit [1-9]' somebody /built/bare
expect 'did you mean "color"' somebody sh -c 'exec /built/bare_c /usr/lib/*/fettle/modules/physics.so'
expect 'the ball hit [1-9]' inside sh -c 'g++ -std=c++20 /examples/bare/main.cpp -o /by-hand $(pkg-config --cflags --libs fettle-physics) &&
    exec /by-hand'
expect 'wind' inside sh -c 'cmake -S /examples/module -B /module >/built.log 2>&1 && cmake --build /module >>/built.log 2>&1 ||
    { cat /built.log; exit 1; }; fettle run /module/game --headless --steps 9 --eval "print(modules.wind.version, \"wind\")"'

# --- Python --------------------------------------------------------------------------------------------------------------------
if [[ -e $python ]]; then
    quietly inside apt-get install -y --no-install-recommends "/packages/$(basename -- "$python")"
    expect '^5 m at 1 s' somebody python3 -c '
import fettle
world = fettle.World(gravity=(0, 0))
ball = world.body(velocity=(5, 0))
for _ in range(60):
    world.step(1 / 60)
print(f"{ball.position.x:.0f} m at 1 s")'
fi

# --- Removing ----------------------------------------------------------------------------------------------------------------
third=()
[[ ! -e $python ]] || third=(python3-fettle)
quietly inside apt-get purge -y fettle fettle-dev "${third[@]}"
left=$(cd -- "$root" && find usr etc var/lib -iname '*fettle*' -not -path 'var/lib/apt/*')
if [[ -n $left ]]; then printf 'left behind:\n%s\n' "$left"; exit 1; fi
echo "the packages install, run, build and go on a bare $codename"
