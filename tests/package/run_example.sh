#!/usr/bin/env bash
# Runs an example in the folder where it was built and checks its output:
# run_example.sh NAME [PROGRAM...]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
example=$1
shift

# The checker must refuse a picture without lines, and one with shifted lines.
check_checker() { # CHECK_LINES PICTURE T
    head -c "$(wc -c <"$2")" /dev/zero | tr '\0' '\377' >white.ppm
    dd if="$2" of=white.ppm bs=15 count=1 conv=notrunc status=none
    # All pixels six to the left.
    { head -c 15 "$2"; tail -c +34 "$2"; head -c 18 /dev/zero; } >shifted.ppm
    local wrong
    for wrong in white.ppm shifted.ppm; do
        if "$1" "$wrong" "$3"; then
            echo "$wrong passes" >&2
            exit 1
        fi
    done
}

expect() { # COUNT PATTERN FILE
    local count
    count=$(grep -cE "$2" "$3") || true
    if [ "$count" != "$1" ]; then
        echo "$3 has $count lines of \"$2\", not $1:" >&2
        cat "$3" >&2
        exit 1
    fi
}

case $example in
window) # CHECK_LINES XVFB_RUN
    "$2" -a ./window 100 window.ppm
    "$1" window.ppm 0.198
    check_checker "$1" window.ppm 0.198
    ;;
own_depth) # CHECK_LINES
    ./own_depth own_depth.ppm >messages.txt
    expect 1 'is multisampled; resolve it' messages.txt
    "$1" own_depth.ppm 0
    check_checker "$1" own_depth.ppm 0
    ;;
device) # CHECK_LINES
    ./device device.ppm >messages.txt
    expect 1 '^threads .* compared with cpp .*: equal in [1-9][0-9]+ kernels$' messages.txt
    "$1" device.ppm 0
    ;;
headless) # LINEATLAS
    ./headless "$here/cube.obj" headless.ppm
    "$1" draw "$here/cube.obj" --size 800x600 -o tool.ppm
    cmp headless.ppm tool.ppm
    ;;
intervals)
    ./intervals >intervals.txt
    # Seen from (4, 5, 8), the far edges of the front box at z = -1 hide two edges of the other box, one at
    # x < 2/3 and one at y < 5/9.
    expect 1 '^edge 12-13: visible from 0[.]66[0-9]+ -1 -2 to 1 -1 -2$' intervals.txt
    expect 1 '^edge 14-12: visible from -1 1 -2 to -1 0[.]55[0-9]+ -2$' intervals.txt
    expect 1 '^edge 2-3: visible from -1 1 -1 to 1 1 -1$' intervals.txt
    expect 1 '^edge 8-10: hidden from -1 -1 -4 to -1 1 -4$' intervals.txt
    # Without an OpenCL driver the library takes `cpp` and says so.
    OCL_ICD_VENDORS=/nonexistent ./intervals >without_opencl.txt 2>note.txt
    expect 1 '^no OpenCL device was found' note.txt
    expect 1 '^edge 12-13: visible from 0[.]66[0-9]+ -1 -2 to 1 -1 -2$' without_opencl.txt
    expect 1 '^edge 8-10: hidden from -1 -1 -4 to -1 1 -4$' without_opencl.txt
    ;;
turntable)
    rm -f turn.*.svg
    ./turntable 3 2>/dev/null
    for number in 0 1 2; do
        (($(grep -c '<path' "turn.$number.svg") > 3)) || { echo "turn.$number.svg has no paths" >&2; exit 1; }
    done
    if cmp --silent turn.0.svg turn.1.svg; then
        echo "nothing turns" >&2
        exit 1
    fi
    # A stopped program says so and leaves only complete drawings.
    rm turn.*.svg
    ./turntable 100000 2>messages.txt &
    until [ -e turn.1.svg ]; do sleep 0.05; done
    kill -INT $!
    if wait $!; then
        echo "it does not say that it was stopped" >&2
        exit 1
    fi
    expect 1 '^stopped; the drawings so far are whole$' messages.txt
    for drawing in turn.*.svg; do expect 1 '^</svg>$' "$drawing"; done
    ;;
pkgconfig) # FOLDER COMPILER EXAMPLES
    export PKG_CONFIG_PATH=$1
    for package in lineatlas lineatlas-headless lineatlas-io; do pkg-config --exists --print-errors $package; done
    libraries=$(pkg-config --variable=libdir lineatlas)
    # shellcheck disable=SC2046 # several words
    "$2" -std=c++20 "$3/intervals/intervals.cpp" -o intervals_by_pkgconfig \
        $(pkg-config --cflags --libs lineatlas-headless) "-Wl,-rpath,$libraries"
    ./intervals_by_pkgconfig >intervals_by_pkgconfig.txt
    expect 1 '^edge 2-3: visible' intervals_by_pkgconfig.txt
    ;;
esac
