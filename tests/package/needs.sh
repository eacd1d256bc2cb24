#!/usr/bin/env bash
# Checks that each library only needs the libraries of its own component: needs.sh FOLDER
set -euo pipefail

status=0
refuse() { # LIBRARY PATTERN...
    local library=$1 pattern
    shift
    for pattern in "$@"; do
        if ldd "$library" | grep -E "^\s*lib($pattern)[.]so"; then
            echo "$library needs it" >&2
            status=1
        fi
    done
}
window_systems='EGL|GL|GLX|OpenGL|glfw|X11|wayland-.*'
refuse "$1/liblineatlas.so" "$window_systems" OpenCL 'OpenMesh.*' 'OpenImageIO.*|png16'
refuse "$1/liblineatlas-headless.so" "GL|GLX|glfw|X11|wayland-.*" 'OpenMesh.*' 'OpenImageIO.*' OpenCL
refuse "$1/liblineatlas-io.so" "$window_systems" 'OpenImageIO.*|png16' OpenCL 'TK.*' 'draco|meshoptimizer'
refuse "$1/lineatlas/lineatlas-png.so" 'OpenImageIO.*'
for library in "$1"/liblineatlas*.so "$1"/lineatlas/lineatlas-{images,png}.so; do refuse "$library" 'embree.*'; done
# The libraries for contexts and for files find the main library beside them.
if LD_LIBRARY_PATH=$1 ldd "$1"/liblineatlas*.so | grep "not found"; then status=1; fi
exit "$status"
