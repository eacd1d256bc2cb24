#!/usr/bin/env bash
# Paths and intervals on a machine without GL, EGL and OpenCL, even without their loaders. The machine is
# a root folder with the programs and their libraries, without libraries of GL, EGL and OpenCL.
# without_gl.sh PREFIX programs FIRST_PROGRAM COMPILER
# without_gl.sh PREFIX python PYTHON PACKAGE_FOLDER
set -euo pipefail
prefix=$1 what=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)

root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT

mkdir "$root/tmp" "$root/proc" "$root/dev"
: >"$root/dev/null"
own=(unshare --mount)
if ((EUID != 0)); then own+=(--user --map-root-user); fi
# Readers, the processes that read files, start by /proc. The mounts end with the last process.
# shellcheck disable=SC2016 # the inner shell's
enter() { # PROGRAM ARG...
    "${own[@]}" sh -ec 'root=$0
mount --rbind /proc "$root/proc"
mount --bind /dev/null "$root/dev/null"
exec chroot "$root" "$@"' "$root" "$@"
}
# shellcheck disable=SC2016
if ! "${own[@]}" sh -ec 'mount --rbind /proc "$0/proc"; chroot / true' "$root" 2>/dev/null; then
    echo "Nobody may change the root folder here: nothing was tested"
    exit 77
fi

hidden='lib(GL|EGL|GLX|GLESv2|OpenGL|GLdispatch|OpenCL|gbm)[.-].*'
place() { # FILE
    local file=$1
    if [ -e "$root$file" ]; then return; fi
    mkdir -p "$root$(dirname "$file")"
    cp -L "$file" "$root$file"
}
add() { # PROGRAM_OR_LIBRARY...
    local file name library
    for file in "$@"; do
        place "$file"
        while read -r name library; do
            if [[ ! $name =~ ^$hidden ]]; then place "$library"; fi
        done < <(ldd "$file" | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 } $1 ~ /^\// { print "loader", $1 }')
    done
}
fail() {
    echo "$*" >&2
    exit 1
}
refusal() { # PATTERN ARG...
    local said pattern=$1
    shift
    if said=$(enter "$prefix/bin/lineatlas" draw /cube.obj "$@" 2>&1); then fail "drawn all the same: $*"; fi
    if [[ ! $said =~ $pattern ]]; then fail "draw $*: $said"; fi
}
expect_paths() { # COUNT FILE
    local count
    count=$(grep -c '<path ' "$root/$2")
    if ((count < $1)); then fail "$2 has $count paths"; fi
}

cp "$here/cube.obj" "$root"

test_programs() { # FIRST_PROGRAM COMPILER
    local first=$1 compiler=$2 library
    add "$prefix/bin/lineatlas" "$first"

    # A program linked to one of these libraries must not start, otherwise this test proves nothing.
    for library in OpenCL EGL; do
        echo 'int main() {}' | "$compiler" -x c++ - -o "$root/linked" -Wl,--no-as-needed "-l$library"
        if enter /linked 2>/dev/null; then fail "a program linked to lib$library starts"; fi
    done
    # Features that need these libraries say so.
    refusal 'there is no libEGL[.]so[.]1' -o /cube.svg --method atlas
    refusal 'no OpenCL device was found [(]libOpenCL[.]so[.]1: ' -o /cube.svg --compute opencl

    enter "$prefix/bin/lineatlas" draw /cube.obj -o /cube.svg --hidden
    expect_paths 5 cube.svg
    enter "$prefix/bin/lineatlas" draw /cube.obj -o /cube.json --plotter
    grep -q '"paths"' "$root/cube.json" || fail "cube.json has no paths"
    enter "$prefix/bin/lineatlas" draw --scene house -o /house.svg --page a4 --style technical
    expect_paths 1000 house.svg
    enter "$first"
    expect_paths 40 first.svg
}

test_python() { # PYTHON PACKAGE_FOLDER
    local python package=$2 standard shared numpy module
    python=$(readlink -f "$1")
    standard=$("$python" -c 'import sysconfig; print(sysconfig.get_path("stdlib"))')
    shared=$("$python" -c 'import sysconfig; print(sysconfig.get_config_var("DESTSHARED"))')
    numpy=$("$python" -c 'import numpy; print(numpy.__path__[0])')
    add "$python" "$package"/_lineatlas*.so
    while read -r module; do add "$module"; done < <(find "$numpy" "$shared" -name '*.so')
    tar --create --exclude=__pycache__ --exclude=test --exclude=tests --exclude='*.a' \
        "$standard" "$numpy" 2>/dev/null | tar --extract --directory "$root"
    cp "$package"/*.py "$root$package"
    cat >"$root/intervals.py" <<PYTHON
import sys
sys.path[:0] = ["$(dirname "$package")", "$(dirname "$numpy")"]
import lineatlas
mesh = lineatlas.load("/cube.obj")
view = lineatlas.View((4, 5, 8), (0, 0, 0))
found = lineatlas.intervals(mesh, view=view, hidden=True)
print(len(found), found["visible"].sum(), lineatlas.to_svg(mesh, view=view).count("<path ") > 3)
try:
    lineatlas.draw(mesh)
except lineatlas.DeviceError as error:
    print(error)
PYTHON
    enter "$python" /intervals.py >"$root/said" || fail "Python stops"
    grep -qx '12 9 True' "$root/said" || fail "Python finds $(cat "$root/said")"
    grep -q 'there is no libEGL' "$root/said" || fail "Python draws: $(cat "$root/said")"
}

"test_$what" "$@"
echo "Paths and intervals are found without GL, EGL and OpenCL"
