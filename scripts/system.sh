#!/usr/bin/env bash
# ./run system SUITE [COMMAND...]: builds as a new user of another Debian would. Makes a system of that
# suite (bookworm, trixie, forky) in build/systems/SUITE unless it exists. Copies this checkout there and
# runs the README's two commands, or COMMAND. The build stays there until you remove the folder.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
. "$root/scripts/debian_root.sh"
[ $# -ge 1 ] || { echo "usage: ./run system SUITE [COMMAND...]" >&2; exit 2; }
suite=$1
shift

system=$root/build/systems/$suite
if [ ! -e "$system/made" ]; then
    rm -rf "$system"
    mkdir -p "$root/build/systems"
    make_debian "$suite" "$system"
    touch "$system/made"
fi
cp /etc/resolv.conf "$system/etc/resolv.conf"
copy=$system/lineatlas
mkdir -p "$copy"
find "$copy" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
git -C "$root" ls-files --cached --others --exclude-standard -z |
    tar -C "$root" --null --files-from=- -c | tar -C "$copy" -x

run_there() { # COMMAND...
    local start=$SECONDS status=0
    echo "$suite: $*"
    # shellcheck disable=SC2016 # the inner shell's
    enter "$system" sh -c 'cd /lineatlas && exec "$@"' sh "$@" || status=$?
    echo "$suite: $* ended with $status after $(((SECONDS - start) / 60)) min $(((SECONDS - start) % 60)) s"
    return $status
}
if (($#)); then
    run_there "$@"
else
    run_there ./run demo
    run_there ./run test
fi
