#!/bin/bash
B=${B:-/work/wt/saves/build/release/bin/fettle}
export XDG_DATA_HOME=/var/tmp/w-saves/data
cd /var/tmp/w-saves/attack
for d in ${1:-*}; do
  [ -d $d ] || continue
  rm -rf $XDG_DATA_HOME
  out=$( (ulimit -v 6000000; timeout 60 nice $B run $d --headless --steps 40 2>&1) ); rc=$?
  echo "$d rc=$rc $(echo "$out" | grep -v '^$' | head -4 | cut -c1-300 | tr '\n' '|')"
done
