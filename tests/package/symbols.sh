#!/usr/bin/env bash
# Compares the exported symbols of the shared libraries in a folder with the lists in
# tests/package/symbols: symbols.sh FOLDER. With --update it writes the lists anew.
set -euo pipefail
lists=$(dirname "$0")/symbols

exported() { # LIBRARY; constructors come twice (for bases and whole objects)
    nm --dynamic --demangle --defined-only "$1" | cut -d' ' -f3- |
        sed 's/@@LINEATLAS_0\.1$//' | LC_ALL=C sort --unique
}

status=0
for library in lineatlas lineatlas-headless lineatlas-io; do
    list=$lists/$library.txt
    if [ "${2:-}" = --update ]; then
        exported "$1/lib$library.so" >"$list"
    elif ! diff -u "$list" <(exported "$1/lib$library.so"); then
        echo "lib$library.so exports something else than $list; if that is right: $0 $1 --update" >&2
        status=1
    fi
done
exit "$status"
