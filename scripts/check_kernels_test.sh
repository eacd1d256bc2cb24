#!/usr/bin/env bash
# check_kernels.sh must find errors that are planted in a copy of the kernels:
#   check_kernels_test.sh PROGRAM     PROGRAM is the built kernel_check
set -euo pipefail
cd "$(dirname "$0")/.."
program=$1
if ! command -v oclgrind >/dev/null; then
    echo "skipped: there is no oclgrind (on Debian 12: apt install oclgrind; Debian 13 has none)"
    exit 77
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LINEATLAS_KERNEL_DIR=$work/kernels

expect() { # WHAT FILE FROM TO WORDS: with FROM replaced by TO in FILE, WORDS are in the report
    rm -rf "$LINEATLAS_KERNEL_DIR"
    cp -r kernels "$LINEATLAS_KERNEL_DIR"
    grep -qF -- "$3" "kernels/$2" || { echo "$2 does not hold: $3"; exit 1; }
    FROM=$3 TO=$4 perl -0pi -e 's/\Q$ENV{FROM}\E/$ENV{TO}/' "$LINEATLAS_KERNEL_DIR/$2"
    if scripts/check_kernels.sh "$program" cpu 1 >"$work/output" 2>&1; then
        echo "Not found: $1"
        exit 1
    fi
    grep -qE -- "$5" "$work/output" || { echo "Found, but not as such: $1"; cat "$work/output"; exit 1; }
    echo "Found: $1"
}

expect "a write outside a buffer" facing.cl "front[i] =" "front[i + 100000] =" "Invalid write"
expect "a race" facing.cl "front[i] =" "front[i / 2] =" "race"
expect "a read of what nobody has written" cull.cl \
    "visible[i] = tiles_hide" "visible[i] = (visible[i] & 4) + tiles_hide" "nobody has written"
expect "a kernel that does not run" pyramid.cl "KERNEL(pyramid" \
    "#define unused_tables(in, out, inout, unordered) in(float, depth)
KERNEL(unused, CountParameters) {}
KERNEL(pyramid" "did not run: .*unused"
# The kernel reads a random value there. The value decides whether the kernel also writes there, and whether Oclgrind survives.
expect "a stroke beyond an atlas that is too small" filter.cl \
    "return is_in_atlas(work->capacity, s, l) ? l : 0u;" "return l;" "Invalid (read|write)|failed under Oclgrind"
