#!/usr/bin/env bash
# Plans every example job into FOLDER/NAME, with a program for each of the controls whose programs are read by other people's interpreters.
# usage: bash tests/examples.sh BLADEWRIGHT FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
mkdir -p "$2"
for job in examples/jobs/*.toml; do
    name=$(basename "$job" .toml)
    "$1" --quiet plan "$job" -o "$2/$name" \
        --set 'post.control=["siemens","siemens-vector","siemens-poly","linuxcnc","linuxcnc-feed"]' >"$2.$name.log" 2>&1 ||
        { cat "$2.$name.log"; exit 1; }
done
