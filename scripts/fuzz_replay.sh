#!/usr/bin/env bash
# scripts/fuzz_replay.sh EXTENSION FOLDER: lets the tool read every file of the folder with this extension. The
# tool must read or refuse each file: exit code 0 or 1, and at most one line. Prints the two counts.
set -euo pipefail

extension=$1
folder=$2
place=$(mktemp -d)
trap 'rm -r "$place"' EXIT
read_ones=0
refused=0
crashed=0
findings=0
for file in "$folder"/*; do
    [ -f "$file" ] || continue
    model=$place/model.$extension
    cp "$file" "$model"
    code=0
    build/release/lineatlas info "$model" --read-seconds 20 >/dev/null 2>"$place/said" || code=$?
    lines=$(wc -l <"$place/said")
    if ((code > 1 || lines > 1 || (code == 1 && lines == 0))); then
        echo "FINDING: $file: exit code $code, $lines lines" >&2
        findings=$((findings + 1))
    elif ((code == 0)); then
        read_ones=$((read_ones + 1))
    elif grep -q 'its reader crashed' "$place/said"; then
        crashed=$((crashed + 1))
    else
        refused=$((refused + 1))
    fi
done
echo "$folder: $read_ones read, $refused refused, $crashed refused since their reader crashed, $findings findings"
((findings == 0))
