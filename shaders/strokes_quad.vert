#version 450 core
// strokes, vertex-shader form: one instance of a four-cornered strip per run.

#include "strokes.glsl"

layout(location = 0) in vec4 ends;
layout(location = 1) in vec4 corners;
layout(location = 2) in vec4 params;
layout(location = 3) in uvec4 indices;
layout(location = 4) in vec4 stroke;

void main() {
    Run run = Run(ends, corners, params, indices, stroke);
    uint i = uint(gl_VertexID);
    Axes axes = axes_of(run);
    set_corner(run, axes, i >> 1, (i & 1u) == 0u ? 1.0 : -1.0);
    set_run(run, axes);
    if (is_left_out(run)) gl_Position = vec4(0.0, 0.0, 0.0, 1.0); // a quad without area
}
