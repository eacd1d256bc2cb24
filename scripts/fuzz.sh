#!/usr/bin/env bash
# ./run fuzz TARGET [--seconds N]: libFuzzer on one target. What it learns is kept in build/fuzz/corpus;
# an input that breaks something is left in build/fuzz/findings and ends the run.
set -euo pipefail

seconds=60
target=
while (($#)); do
    case $1 in
    --seconds)
        seconds=${2:?--seconds needs a number}
        shift
        ;;
    *) target=$1 ;;
    esac
    shift
done

inputs=tests/fuzz/inputs
if [ -z "$target" ] || [ ! -d "$inputs/$target" ]; then
    echo "Usage: ./run fuzz TARGET [--seconds N]; targets:" "$(ls $inputs)" >&2
    exit 2
fi
if ! [[ $seconds =~ ^[0-9]+$ ]]; then
    echo "fuzz: --seconds needs a whole number, not \"$seconds\"" >&2
    exit 2
fi

[ -f build/fuzz/build.ninja ] || cmake --preset fuzz >/dev/null
cmake --build build/fuzz --target "fuzz_$target" -- --quiet
export LINEATLAS_MODULE_DIR=$PWD/build/fuzz/lib/lineatlas
corpus=build/fuzz/corpus/$target
findings=build/fuzz/findings/$target
mkdir -p "$corpus" "$findings"
"$(find build/fuzz -name "fuzz_$target" -type f -perm -u+x)" \
    -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=1024 -max_len=65536 \
    -dict=tests/fuzz/dictionaries/words.dict -artifact_prefix="$findings/" -print_final_stats=1 \
    "$corpus" "$inputs/$target"
