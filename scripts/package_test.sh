#!/usr/bin/env bash
# ./run package-test [--system SUITE] [--blender]: installs the wheel in a clean Debian of this machine's
# suite, or of SUITE, and the packages in a second one. Uses each as a new user would, removes it, and
# checks that nothing is left. Needs the results of `./run package` and `./run wheel`. Prints the time of
# each step. With --blender it also tries the add-on with Blender's 300 packages.
set -euo pipefail

source=$PWD
. scripts/debian_root.sh
# shellcheck disable=SC1091
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
blender=
while (($#)); do
    case $1 in
    --system) suite=$2 && shift 2 ;;
    --blender) blender=yes && shift ;;
    *) echo "usage: ./run package-test [--system SUITE] [--blender]" >&2 && exit 2 ;;
    esac
done
compgen -G "build/package/*.deb" >/dev/null || { echo "package-test: run ./run package first" >&2; exit 1; }
compgen -G "build/wheel/*.whl" >/dev/null || { echo "package-test: run ./run wheel first" >&2; exit 1; }

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
log=$folder/log
fail() {
    tail -n 30 "$log" >&2 || true
    echo "package-test: $*" >&2
    exit 1
}
step() { # WHAT COMMAND...
    local what=$1 start=$SECONDS
    shift
    "$@" >"$log" 2>&1 || fail "$what"
    echo "$((SECONDS - start)) s: $what"
}
install() { # PACKAGE...
    enter "$root" apt-get install -y -qq "$@"
}
make_root() { # NAME
    root=$folder/$1
    mkdir "$root"
    tar -C "$root" -xf "$folder/clean.tar"
    cp /etc/resolv.conf "$root/etc/resolv.conf"
    cp "$source/tests/package/cube.obj" "$root/root"
    enter "$root" apt-get update -qq
}
is_png() { # FILE
    [ "$(head -c 4 "$root/root/$1" | tail -c 3)" = PNG ] || fail "$1 is no picture"
}
has_paths() { # FILE
    (($(grep -c '<path ' "$root/root/$1") > 3)) || fail "$1 has no paths"
}
nothing_left() {
    local left
    left=$(find "$root" -xdev \( -path "$root/proc" -o -path "$root/sys" -o -path "$root/packages" -o -path "$root/root" \
        -o -path "$root/var/lib/apt" -o -path "$root/var/log" \) -prune -o -name '*lineatlas*' -print)
    [ -z "$left" ] || fail "left behind: $left"
}

step "a clean $suite" make_debian "$suite" "$folder/clean.tar"

# The wheel with the system's Python, without OpenGL and OpenCL.
step "the root for the wheel" make_root wheel
step "Python and NumPy" install --no-install-recommends python3-venv python3-numpy
cp build/wheel/*.whl "$root/root"
cat >"$root/root/use.py" <<'PYTHON'
import lineatlas

mesh = lineatlas.load("/root/cube.obj")
view = lineatlas.View((4, 5, 8), (0, 0, 0))
assert len(lineatlas.intervals(mesh, view=view)) == 9
assert lineatlas.to_svg(mesh, view=view).count("<path ") > 3
picture = __import__("numpy").zeros((4, 4, 4), "uint8")
lineatlas.save("/root/empty.png", picture)
try:
    lineatlas.draw(mesh)
except lineatlas.DeviceError as error:
    assert "libEGL" in str(error), error
else:
    raise SystemExit("draws without OpenGL?")
PYTHON
step "a fresh virtual environment" enter "$root" python3 -m venv --system-site-packages /root/venv
step "pip install of the wheel" enter "$root" sh -c '/root/venv/bin/pip install --no-index --no-deps /root/*.whl'
enter "$root" sh -c '! ls /usr/lib/*/libEGL* /usr/lib/*/libOpenCL* /usr/lib/*/libepoxy* 2>/dev/null' || fail "the root is not bare"
step "the wheel without OpenGL and OpenCL" enter "$root" /root/venv/bin/python /root/use.py
is_png empty.png
step "pip uninstall" enter "$root" /root/venv/bin/pip uninstall -y lineatlas
rm "$root"/root/*.whl
[ -z "$(find "$root/root/venv" -name '*lineatlas*')" ] || fail "the wheel leaves files behind"
rm -rf "$root"

# The packages.
step "the root for packages" make_root packages
mkdir "$root/packages"
cp build/package/*.deb "$root/packages"
own() { # NAME...: files of these packages, without the version
    local name
    for name in "$@"; do basename "$root"/packages/"$name"_*.deb | sed 's,^,/packages/,'; done
}
mapfile -t files < <(own lineatlas lineatlas-doc lineatlas-viewer lineatlas-bench liblineatlas0.1 liblineatlas-io0.1)
step "apt install of the tool with viewer, bench and drivers" install "${files[@]}"
step "lineatlas draw to PNG" enter "$root" lineatlas draw --scene clevis -o /root/clevis.png --size 400x300
is_png clevis.png
step "lineatlas draw to SVG" enter "$root" lineatlas draw /root/cube.obj -o /root/cube.svg
has_paths cube.svg
step "lineatlas devices" enter "$root" lineatlas devices
grep -q opencl "$log" || fail "no OpenCL device"
if [ "$suite" = bookworm ]; then # the page shows output of bookworm's PoCL
    cp tests/package/walk.sh "$root/root"
    step "objdump for it" install --no-install-recommends binutils
    step "the walk of profiling.md" enter "$root" /root/walk.sh /usr/share/doc/lineatlas/docs/profiling.md \
        /usr/bin/lineatlas /usr/share/lineatlas/kernels
fi
step "lineatlas bench" enter "$root" lineatlas bench kernels --help
step "lineatlas view" enter "$root" lineatlas view --help
if enter "$root" lineatlas view >"$log" 2>&1; then fail "a viewer without a display"; fi
(($(wc -l <"$log") <= 2)) || fail "the viewer does not say in one line that there is no display"
step "a display that nobody sees" install --no-install-recommends xvfb
# The display writes its picture to a file. Once the window is open it has white paper with black lines.
# shellcheck disable=SC2016
step "the viewer in a window" enter "$root" sh -ec 'cd /root
mkdir screen
Xvfb :7 -screen 0 900x600x24 -fbdir screen &
until [ -e /tmp/.X11-unix/X7 ]; do sleep 0.1; done
DISPLAY=:7 lineatlas view cube.obj --size 900x600 --theme light &
viewer=$!
pixels() { tail -c 2160000 screen/Xvfb_screen0 | od -An -v -tx4 -w4 | grep -c "$1"; }
for try in $(seq 60); do
    kill -0 $viewer
    if [ "$(pixels ffffff)" -gt 200000 ] && [ "$(pixels 000000)" -gt 500 ]; then exit 0; fi
    sleep 1
done
exit 1'
for page in lineatlas lineatlas-draw lineatlas-view lineatlas-bench-frames; do
    [ -e "$root/usr/share/man/man1/$page.1.gz" ] || fail "no manual page of $page"
done
step "shared-mime-info and desktop-file-utils" install --no-install-recommends shared-mime-info desktop-file-utils
grep -q 'model/step=lineatlas.desktop' "$root/usr/share/applications/mimeinfo.cache" || fail "no program for model/step"
grep -q 'model/x-ply:\*.ply' "$root/usr/share/mime/globs" || fail "no type for *.ply"
enter "$root" desktop-file-validate /usr/share/applications/lineatlas.desktop || fail "the desktop entry"
# shellcheck disable=SC2016
enter "$root" bash -c '. /usr/share/bash-completion/completions/lineatlas
COMP_WORDS=(lineatlas dr); COMP_CWORD=1; _lineatlas; [ "${COMPREPLY[*]}" = draw ]' || fail "no completion"

mapfile -t files < <(own liblineatlas-dev liblineatlas-io-dev lineatlas-doc)
step "apt install to develop" install --no-install-recommends "${files[@]}" g++ pkg-config
[ -e "$root/usr/share/doc/lineatlas/docs/images/overview.png" ] || fail "no pictures of the documents"
sed -n '/^\/\/ first.cpp/,/^```/p' README.md | sed '$d' >"$root/root/first.cpp"
# shellcheck disable=SC2016
step "the README's program, compiled and run" enter "$root" sh -ec 'cd /root
g++ -std=c++20 first.cpp -o first $(pkg-config --cflags --libs lineatlas)
./first'
has_paths first.svg

mapfile -t files < <(own python3-lineatlas)
step "apt install for Python" install --no-install-recommends "${files[@]}"
step "a picture from Python" enter "$root" /usr/bin/python3 -c '
import lineatlas
lineatlas.save("/root/python.png", lineatlas.draw("/root/cube.obj", size=(300, 200)))'
is_png python.png

mapfile -t files < <(own lineatlas-brep lineatlas-pdf lineatlas-rays)
step "apt install for STEP, PDF and checks" install --no-install-recommends "${files[@]}"
step "PDF, and a check by rays" enter "$root" sh -ec 'cd /root
lineatlas draw cube.obj -o cube.pdf
lineatlas draw cube.obj -o cube.svg --eye 4,5,8 --target 0,0,0
lineatlas check cube.svg cube.obj'

if [ "$blender" ]; then
    mapfile -t files < <(own lineatlas-blender)
    step "apt install for Blender" install --no-install-recommends "${files[@]}"
    cp "$source"/integrations/blender/tests/package.py "$root/root"
    step "lines in Blender" enter "$root" sh -ec 'cd /root
blender -b --factory-startup --python-exit-code 1 --python package.py -- /root'
    is_png blender_0001_lines.png
fi

step "apt purge" enter "$root" sh -ec "apt-get purge -y -qq '~nlineatlas' && apt-get autoremove --purge -y -qq"
nothing_left
echo "Packages and wheel install, work and go in a clean $suite"
