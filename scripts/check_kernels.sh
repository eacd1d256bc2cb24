#!/usr/bin/env bash
# Runs every kernel under Oclgrind, an OpenCL device that watches each access:
#   check_kernels.sh PROGRAM [ARGS]     PROGRAM is the built kernel_check
# Fails on any report (access outside a buffer, race, wrong API call), on a result that depends on
# uninitialised memory, and if a kernel of kernels/ did not run.
#
# Oclgrind's option --uninitialized does not work here. The version of Debian 12 (21.10, LLVM 14) takes
# the mask of every vector shuffle for an operand, reports initialised memory
# (https://github.com/jrprice/Oclgrind/issues/126) or crashes. So PROGRAM itself finds reads of
# uninitialised buffers (tests/compute/kernel_check.cpp). Nothing finds reads of uninitialised
# variables. The option --max-errors does not work either: with it 21.10 leaves the log empty. With
# --inst-counts it writes beyond its own tables (InstructionCounter::workGroupComplete) and may crash, so
# PROGRAM says which kernels have run.
set -euo pipefail
cd "$(dirname "$0")/.."
if ! command -v oclgrind >/dev/null; then
    echo "skipped: there is no oclgrind (on Debian 12: apt install oclgrind; Debian 13 has none)"
    exit 77
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
kernels=${LINEATLAS_KERNEL_DIR:-kernels}

if ! oclgrind --check-api --data-races \
    --log "$work/reports" "$@" >"$work/output" 2>"$work/errors"; then
    echo "The program failed under Oclgrind:"
    tail -n 40 "$work/output" "$work/errors" "$work/reports"
    exit 1
fi
if [ -s "$work/reports" ]; then
    echo "Oclgrind reports:"
    head -60 "$work/reports"
    exit 1
fi

sed -n 's/^ran //p' "$work/output" | sort -u >"$work/ran"
cat "$kernels"/*.cl | sed -nE 's/^KERNEL\(([a-z_0-9]+),.*/\1/p' | sort -u >"$work/known"
if [ -n "$(comm -13 "$work/ran" "$work/known")" ]; then
    echo "Kernels that did not run: $(comm -13 "$work/ran" "$work/known" | xargs)"
    exit 1
fi
grep '^checked' "$work/output"
echo "No report on $(wc -l <"$work/known") kernels: $(xargs <"$work/known")"
