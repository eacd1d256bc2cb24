#!/usr/bin/env bash
# ./run wheel: builds the Python package as a wheel in build/wheel, with all libraries but those of the
# machine: libc, the C++ library, and drivers of OpenGL and OpenCL, which it opens when it draws. It
# reads all types of models but STEP, IGES and BREP, and writes pictures as PNG only: Open CASCADE and
# OpenImageIO would be larger than all other libraries together.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$root/build/wheel/build
folder=$root/build/wheel/content
python=/usr/bin/python3
most_megabytes=25

cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DLINEATLAS_OPENIMAGEIO=OFF \
    -DLINEATLAS_TESTS=OFF -DLINEATLAS_BENCH=OFF -DLINEATLAS_VIEWER=OFF >/dev/null
cmake --build "$build" --target lineatlas_python lineatlas-png lineatlas-gltf lineatlas-3mf -- --quiet

rm -rf "$folder"
mkdir -p "$folder"/lineatlas/lib/lineatlas "$folder"/lineatlas.libs
cp -L "$build"/python/lineatlas/{*.py,*.pyi,py.typed,_lineatlas*.so} "$folder/lineatlas"
cp "$build"/lib/lineatlas/lineatlas-{png,gltf,3mf}.so "$folder/lineatlas/lib/lineatlas"
own=("$folder"/lineatlas/*.so "$folder"/lineatlas/lib/lineatlas/*.so)

is_of_the_machine() {
    case $1 in
    ld-linux* | linux-vdso* | libc.so* | libm.so* | libdl.so* | libpthread.so* | librt.so*) ;;
    libstdc++.so* | libgcc_s.so*) ;;
    *) return 1 ;;
    esac
}
# The libraries get new names, because other packages in the process may bring libraries of the same name.
new_name() { # libNAME.so.N
    echo "${1%%.so*}-lineatlas.so${1#*.so}"
}

info=$folder/lineatlas-VERSION.dist-info
mkdir -p "$info/licenses"
cp "$root/LICENSE" "$info/licenses"
libraries=()
while read -r name path; do
    if is_of_the_machine "$name"; then continue; fi
    libraries+=("$name")
    cp -L "$path" "$folder/lineatlas.libs/$(new_name "$name")"
    package=$(dpkg-query -S "*/$(basename "$(readlink -f "$path")")" 2>/dev/null | head -n 1 | cut -d: -f1)
    cp "/usr/share/doc/$package/copyright" "$info/licenses/$package"
done < <(ldd "${own[@]}" | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 }' | sort -u)

chmod -R u+w "$folder"
strip --strip-unneeded "${own[@]}" "$folder"/lineatlas.libs/*
# One change per call, because patchelf 0.14 mixes up the strings of several changes.
# shellcheck disable=SC2016 # $ORIGIN is the loader's
{
    patchelf --set-rpath '$ORIGIN/../lineatlas.libs' "$folder"/lineatlas/*.so
    patchelf --set-rpath '$ORIGIN/../../../lineatlas.libs' "$folder"/lineatlas/lib/lineatlas/*.so
    patchelf --set-rpath '$ORIGIN' "$folder"/lineatlas.libs/*
}
for library in "$folder"/lineatlas.libs/*; do patchelf --set-soname "$(basename "$library")" "$library"; done
for name in "${libraries[@]}"; do
    patchelf --replace-needed "$name" "$(new_name "$name")" "${own[@]}" "$folder"/lineatlas.libs/*
done

"$python" "$root/packaging/wheel.py" "$folder" "$root/build/wheel" \
    "$(sed -n 's/^project(lineatlas VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")"
wheel=$(ls "$root"/build/wheel/*.whl)
megabytes=$(($(stat -c %s "$wheel") / 1000000 + 1))
echo "$wheel: $megabytes MB"
if ((megabytes > most_megabytes)); then
    echo "wheel: more than $most_megabytes MB" >&2
    exit 1
fi
