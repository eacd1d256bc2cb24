#!/usr/bin/env bash
# ./run fuzz TARGET [--seconds N]: runs libFuzzer on one target. The corpus stays in build/fuzz/corpus. An
# input that breaks something goes to build/fuzz/findings and ends the run.
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
# Open CASCADE crashes on damaged files. In the tool only the reading process crashes. So the fuzzer goes on after a crash,
# and an input is a finding only if the tool does not answer it in one line.
by_itself=()
replayed=
case $target in
3mf) # lib3mf leaks some bytes of every archive that it reads
    by_itself=(-detect_leaks=0)
    export ASAN_OPTIONS=detect_leaks=0
    ;;
step | iges | brep)
    by_itself=(-fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 -close_fd_mask=1)
    replayed=yes
    cmake --preset release >/dev/null
    cmake --build build/release --target lineatlas -- --quiet
    ;;
esac
corpus=build/fuzz/corpus/$target
findings=build/fuzz/findings/$target
mkdir -p "$corpus" "$findings"
"$(find build/fuzz -name "fuzz_$target" -type f -perm -u+x)" \
    -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=1024 -max_len=65536 \
    -dict=tests/fuzz/dictionaries/words.dict -artifact_prefix="$findings/" -print_final_stats=1 \
    "${by_itself[@]}" "$corpus" "$inputs/$target" || [ "$replayed" ]
[ "$replayed" ] || exit 0
unset LINEATLAS_MODULE_DIR
scripts/fuzz_replay.sh "$target" "$findings"
