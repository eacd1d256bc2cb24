#!/usr/bin/env bash
# Checks the messages of configuring if the library of a part is missing: parts.sh SOURCES
set -euo pipefail
sources=$1
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT

configure() { # OPTION...
    cmake -S "$sources" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_DISABLE_FIND_PACKAGE_embree=ON \
        "$@" >"$build/said" 2>&1
}
fail() {
    cat "$build/said"
    echo "parts: $*" >&2
    exit 1
}
says() { # PATTERN
    grep -q -- "$1" "$build/said" || fail "no line with: $1"
}

configure || fail "a part that is missing ends it"
says 'drawings checked by rays *LEFT OUT: there is no Embree 3 or 4 (on Debian: apt install libembree-dev)'
says 'glTF models *built'
if configure -DLINEATLAS_ALL_PARTS=ON; then fail "a part is missing where all are wanted"; fi
says 'LEFT OUT: there is no Embree 3 or 4'
says '-DLINEATLAS_RAYS=OFF'
configure -DLINEATLAS_ALL_PARTS=ON -DLINEATLAS_RAYS=OFF || fail "a part left out on purpose is missed"
says 'drawings checked by rays *left out, as LINEATLAS_RAYS says'
