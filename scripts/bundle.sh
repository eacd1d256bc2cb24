#!/usr/bin/env bash
# Packs build/bundle with all needed libraries into a folder: scripts/bundle.sh DIR
# Lists the targets to build for it: scripts/bundle.sh --targets
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$root/build/bundle
most_megabytes=60
programs=(lineatlas lineatlas-check lineatlas-bench-{frames,kernels,interop})
tests=({sharing_modes,stages,compute,pictures}_test) # the tests that bench/check/parts.cpp runs

if [ "${1:-}" = --targets ]; then
    echo "${programs[@]}" "${tests[@]}"
    exit
fi
if [ $# -ne 1 ]; then
    echo "usage: ./run bundle DIR" >&2
    exit 2
fi
target=$1
if [ -e "$target" ] && [ ! -f "$target/lib/environment.sh" ] && [ -n "$(ls -A "$target")" ]; then
    echo "bundle: $target is there and no bundle; name a new folder" >&2
    exit 1
fi
rm -rf "$target"
mkdir -p "$target"/{bin,tests,lib/lineatlas,share/docs,share/licenses}
target=$(cd "$target" && pwd)

# True for libraries that every machine has: libc with its loader, and drivers.
is_of_the_machine() {
    case $1 in
    ld-linux* | linux-vdso* | libc.so* | libm.so* | libdl.so* | libpthread.so* | librt.so*) ;;
    libGL.so* | libGLX.so* | libOpenGL.so* | libEGL.so* | libGLdispatch.so*) ;;
    *) return 1 ;;
    esac
}

# The fallback folder of a library. Fallbacks are only used if the machine's own library is missing or too old
# (lib/environment.sh), because the machine's drivers need its own libraries.
fallback_for() {
    case $1 in
    libstdc++.so* | libgcc_s.so*) echo stdc++ ;;
    esac
}

add_license() { # LIBRARY
    local package
    # A package may list /lib instead of /usr/lib.
    package=$(dpkg-query -S "*/x86_64-linux-gnu/$(basename "$1")" 2>/dev/null | head -n 1 | cut -d: -f1) || true
    if [ -n "$package" ]; then
        cp -f "/usr/share/doc/$package/copyright" "$target/share/licenses/$package"
    fi
}

# Copies all libraries of a program. ldd also lists the libraries of libraries.
add_libraries_of() { # PROGRAM
    local name path folder
    while read -r name path; do
        if is_of_the_machine "$name"; then continue; fi
        folder=$target/lib
        if [ -n "$(fallback_for "$name")" ]; then
            folder=$target/lib/fallback/$(fallback_for "$name")
        fi
        if [ -e "$folder/$name" ]; then continue; fi
        mkdir -p "$folder"
        cp -L "$path" "$folder/$name"
        add_license "$(readlink -f "$path")"
    done < <(ldd "$1" | awk '$2 == "=>" { print $1, $3 }')
}

for program in "${programs[@]}"; do cp "$build/$program" "$target/bin"; done
for test in "${tests[@]}"; do cp "$build/tests/$test" "$target/tests"; done
cp "$build/lib/lineatlas/lineatlas-png.so" "$target/lib/lineatlas"
for file in "$target"/bin/* "$target"/tests/* "$target/lib/lineatlas/lineatlas-png.so"; do
    add_libraries_of "$file"
done

# The dispatchers in front of drivers of GL and OpenCL. Programs open them at run time. Machines for
# computing often have drivers of GL without dispatchers.
mkdir -p "$target"/lib/fallback/{gl,opencl}
for name in gl/libEGL.so.1 gl/libOpenGL.so.0 gl/libGLdispatch.so.0 opencl/libOpenCL.so.1; do
    folder=$target/lib/fallback/$(dirname "$name")
    name=$(basename "$name")
    cp -L "/usr/lib/x86_64-linux-gnu/$name" "$folder"
    add_license "$(readlink -f "/usr/lib/x86_64-linux-gnu/$name")"
done

find "$target"/{bin,tests,lib} -type f -exec chmod u+w {} + -exec strip --strip-unneeded {} +
# shellcheck disable=SC2016 # $ORIGIN is the loader's
{
    patchelf --set-rpath '$ORIGIN/../lib' "$target"/bin/* "$target"/tests/*
    patchelf --set-rpath '$ORIGIN/..' "$target/lib/lineatlas/lineatlas-png.so"
    patchelf --set-rpath '$ORIGIN' "$target"/lib/*.so*
}

cp -r "$root"/{kernels,shaders,styles} "$target/share"
cp "$root/docs/styles.md" "$target/share/docs"
cp "$root/LICENSE" "$target"
cp "$root/docs/bundle.md" "$target/README.md"
cp "$root/scripts/bundle/environment.sh" "$target/lib"
cp "$root"/scripts/bundle/{check,lineatlas} "$target"

# The pictures of this machine, with which `check` compares those of another.
mkdir "$target/share/pictures"
(
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    "$target/check" --part "picture cpp" --part "scan cpp" --json "$scratch/check.json" >/dev/null
    for name in picture scan; do cp "$scratch/check-pictures/$name-cpp.png" "$target/share/pictures/$name.png"; done
)

"$root/scripts/bundle/verify.sh" "$target"
megabytes=$(($(du -s --apparent-size --block-size=1000 "$target" | cut -f1) / 1000 + 1))
echo "$target: $megabytes MB"
if ((megabytes > most_megabytes)); then
    echo "bundle: more than $most_megabytes MB" >&2
    exit 1
fi
