#version 450 core
// strokes, vertex-shader form: one instance of a four-cornered strip per run.

#include "strokes.glsl"

layout(location = 0) in vec4 ends;
layout(location = 1) in vec4 corners;
layout(location = 2) in vec4 params;
layout(location = 3) in uvec4 indices;
layout(location = 4) in vec4 stroke;

noperspective out vec2 local;
flat out vec4 run_ends;
flat out vec4 run_corners;
flat out vec4 run_params;
flat out uvec4 run_indices;
flat out vec4 run_stroke;

void main() {
    Run run = Run(ends, corners, params, indices, stroke);
    uint i = uint(gl_VertexID);
    Corner corner = stroke_corner(run, i >> 1, (i & 1u) == 0u ? 1.0 : -1.0);
    local = corner.local;
    run_ends = run.ends;
    run_corners = run.corners;
    run_params = run.params;
    run_indices = run.indices;
    run_stroke = run.stroke;
    gl_Position = corner.position;
}
