#!/usr/bin/env bash
# walk.sh PAGE TOOL KERNELS: runs every block of commands in PAGE (docs/profiling.md) with the program
# TOOL. KERNELS replaces the folder /usr/share/lineatlas/kernels, and TOOL's folder replaces /usr/bin.
# If a block of output follows, the commands must print each of its lines, with any numbers and
# verdicts. Output of perf is random and not compared. To save time the house replaces the ship, and
# three frames and twelve turns replace more. Watching ends after 20 s.
set -euo pipefail

page=$(realpath "$1") tool=$(realpath "$2") kernels=$(realpath "$3")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/bin"
ln -s "$tool" "$folder/bin/lineatlas"
PATH=$folder/bin:$PATH
cd "$folder"

# Writes each block to N.sh and its output, if the page shows it, to N.txt, without the indentation of lists.
awk '/^ *```sh$/ { file = ++n ".sh"; next }
     /^ *```$/ && file { close(file); last = file; file = ""; next }
     /^ *```$/ && last { sub("sh", "txt", last); file = last; last = ""; match($0, /^ */); indent = RLENGTH; next }
     /^ *```/ { last = ""; next }
     file { print substr($0, file ~ /txt/ ? indent + 1 : 1) > file }' "$page"

without_numbers() {
    sed -E 's/ on opencl: .*\): / on a device: /; s/, (avx[0-9]+|baseline): /, a set: /; s/loop [0-9a-f]+ to [0-9a-f]+/loop/; s/[0-9]+(\.[0-9]+)?/N/g; s/ +/ /g; s/ -/ N/g; s/^ //; s/ (same|cannot be told|latency|memory|arithmetic|launch)?$//' "$1"
}
is_printed() { # LINE
    grep -Fxq -- "$1" seen || { cat printed && echo "walk: not printed: $1" >&2 && exit 1; }
}
count=0
for block in $(printf '%s\n' *.sh | sort -n); do
    output=${block%.sh}.txt what=$(sed 's/^ *//;q' "$block")
    sed -i -E "s,--scene ship,--scene house,; s,--repeat [0-9]+,--repeat 3,; s,--turns 20,--turns 12,; s,/usr/share/lineatlas/kernels,$kernels,; s,/usr/bin,${tool%/*},; s,lineatlas bench kernels --watch,timeout 20 &," "$block"
    if grep -q '^ *perf ' "$block"; then
        if ! perf stat true 2>/dev/null; then
            echo "walk: not walked, perf does not work here: $what"
            continue
        fi
        rm -f "$output"
    fi
    start=$SECONDS
    bash -euo pipefail "$block" >printed 2>&1 || case $? in
    124 | 141) ;; # ended by timeout, or by a pipe that was not read to its end
    *) cat printed && exit 1 ;;
    esac
    echo "walk: $((SECONDS - start)) s: $what"
    [ -s printed ] || { echo "walk: nothing is printed" >&2 && exit 1; }
    without_numbers printed >seen
    [ ! -e "$output" ] || without_numbers "$output" | while read -r line; do is_printed "$line"; done
    count=$((count + 1))
done
for file in trace.json events.csv; do [ -s "$file" ] || { echo "walk: no $file" >&2 && exit 1; }; done
((count >= 5)) || { echo "walk: only $count blocks" >&2 && exit 1; }
