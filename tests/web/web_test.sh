#!/bin/sh
# Usage: web_test.sh SOURCES NATIVE_DRAWINGS. What ./run web has built is brought up to date first.
set -eu
skip() {
    echo "Skipped: $1"
    exit 77
}
command -v node >/dev/null || skip "there is no node (on Debian: apt install nodejs)"
[ -f "$1/build/web/build.ninja" ] || skip "there is no build/web; ./run web makes it"
cmake --build "$1/build/web" --target lineatlas_package -- --quiet
drawings=$(mktemp -d)
trap 'rm -r "$drawings"' EXIT
"$2" "$drawings"
WEB_PACKAGE=$1/build/web/package WEB_DRAWINGS=$drawings node --test "$(dirname "$0")"/*_test.mjs
