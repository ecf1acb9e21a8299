#!/usr/bin/env bash
# The installed shared libraries may export only names of the public headers and names in C. A module may export only its
# entry point.
#
#   symbols.sh PREFIX LIBRARIES NM OBJDUMP
set -euo pipefail
prefix=$1 libraries=$2 nm=$3 objdump=$4
words=$(mktemp)
trap 'rm -f -- "$words"' EXIT

# One exported C++ name per line; for a table or a guard, the name of its class or variable.
shown() {
    "$nm" -D -C --defined-only -- "$1" | sed -E 's/^[0-9a-f]* [A-Za-z] //
        s/^((vtable|VTT|typeinfo|typeinfo name|guard variable) for |(non-virtual|virtual|covariant return) thunk to )//'
}

# Its namespaces, classes and the name itself, without parameters and template arguments.
identifiers() {
    sed -E 's/^([^(<]* )?(fettle::[^(<[]*).*/\2/; s/operator.*//; s/::~/::/g; s/::/\n/g' | sed '/^ *$/d' | sort -u
}

grep -rhoE '[A-Za-z_][A-Za-z0-9_]*' "$prefix/include/fettle" | sort -u >"$words"
count=0 names=0 wrong=0
for file in "$libraries"/libfettle_*.so; do
    [[ -e $file ]] || continue
    all=$(shown "$file")
    foreign=$(grep -vE '^([^(]* )?fettle(::|_[a-z_0-9]+$)' <<<"$all" || true)
    private=$({ grep 'fettle::' <<<"$all" || true; } | identifiers | comm -23 - "$words")
    wanted=$(basename -- "$(readlink -f -- "$file")" | sed -E 's/(\.so\.0\.[0-9]+|\.so\.[1-9][0-9]*)\..*/\1/')
    if [[ ! -e $libraries/$wanted || $("$objdump" -p "$file") != *SONAME*"$wanted"* ]]; then
        printf '%s does not export %s\n' "${file##*/}" "$wanted"
        wrong=1
    fi
    printf '%s: %d bytes, %d names\n' "$wanted" "$(stat -Lc %s -- "$file")" "$(wc -l <<<"$all")"
    if [[ -n $foreign ]]; then printf '%s exports names that are not of Fettle:\n%s\n' "${file##*/}" "$foreign"; wrong=1; fi
    if [[ -n $private ]]; then printf '%s exports names that are in no public header:\n%s\n' "${file##*/}" "$private"; wrong=1; fi
    count=$((count + 1)) names=$((names + $(wc -l <<<"$all")))
done
for file in "$libraries"/fettle/modules/*.so; do
    all=$(shown "$file")
    if [[ $all != fettle_module_open ]]; then printf '%s shows more than its entry point:\n%s\n' "$file" "$all"; wrong=1; fi
    count=$((count + 1)) names=$((names + 1))
done
((wrong == 0)) && printf 'nothing but what is public: %d shared objects, %d names\n' "$count" "$names"
