#!/usr/bin/env bash
# Checks that a bundle is complete: verify.sh DIR. Every needed library must be in the bundle and must be
# looked for there, or belong to every machine. Some large libraries must not be in it. Prints the
# version of glibc that the bundle needs.
set -euo pipefail
target=$1
failed=0

complain() {
    echo "bundle: $1" >&2
    failed=1
}

needs() { # FILE
    readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'
}

mapfile -t files < <(find "$target"/{bin,tests,lib} -type f -exec sh -c 'head -c 4 "$1" | grep -q ELF' _ {} \; -print)
for file in "${files[@]}"; do
    for name in $(needs "$file"); do
        if [ -e "$target/lib/$name" ]; then continue; fi
        case $name in
        libc.so.6 | libm.so.6 | libdl.so.2 | libpthread.so.0 | librt.so.1 | ld-linux-x86-64.so.2) ;;
        libGL.so.1 | libGLX.so.0 | libOpenGL.so.0 | libEGL.so.1 | libGLdispatch.so.0) ;;
        libOpenCL.so.1) [ -e "$target/lib/fallback/opencl/$name" ] || complain "$name is missing" ;;
        libstdc++.so.6 | libgcc_s.so.1)
            [ -e "$target/lib/fallback/stdc++/$name" ] || complain "$name is missing"
            ;;
        *) complain "${file#"$target"/} needs $name, which is not in it" ;;
        esac
    done
    case $file in "$target"/lib/fallback/*) continue ;; esac
    # shellcheck disable=SC2016 # $ORIGIN is the loader's
    readelf -d "$file" | grep -q 'RUNPATH.*\[$ORIGIN' ||
        complain "${file#"$target"/} does not look for libraries beside itself"
done

for library in "$target"/lib/lib{TK,OpenEXR,OpenImageIO,embree}*; do
    if [ -e "$library" ]; then complain "$(basename "$library") does not belong in it"; fi
done

glibc=$(readelf -V "${files[@]}" | grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n 1)
echo "needs glibc ${glibc#GLIBC_} or newer"
exit $failed
