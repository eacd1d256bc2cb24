# shellcheck shell=sh disable=SC2154 # the reading script sets $here
# Read by the scripts of a bundle, which set $here. Chooses the bundle's own C++ library, OpenCL loader
# or GL dispatchers only if programs do not work with the machine's, which the machine's drivers need.
export LINEATLAS_BUNDLE_FALLBACK=""
machine_paths=${LD_LIBRARY_PATH:-}
for libraries in "" stdc++; do
    paths=""
    for library in $libraries; do paths="$paths$here/lib/fallback/$library:"; done
    LD_LIBRARY_PATH="$paths$machine_paths"
    if [ -z "$LD_LIBRARY_PATH" ]; then unset LD_LIBRARY_PATH; else export LD_LIBRARY_PATH; fi
    if "$here/bin/lineatlas" --help >/dev/null 2>&1; then
        LINEATLAS_BUNDLE_FALLBACK=$libraries
        break
    fi
done
if ! "$here/bin/lineatlas-check" --has-opencl >/dev/null 2>&1; then
    export LD_LIBRARY_PATH="$here/lib/fallback/opencl${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
    LINEATLAS_BUNDLE_FALLBACK="$LINEATLAS_BUNDLE_FALLBACK opencl"
fi
if ! "$here/bin/lineatlas-check" --has-gl >/dev/null 2>&1; then
    export LD_LIBRARY_PATH="$here/lib/fallback/gl${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
    LINEATLAS_BUNDLE_FALLBACK="$LINEATLAS_BUNDLE_FALLBACK gl"
fi
unset machine_paths libraries library paths
