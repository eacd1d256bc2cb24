#version 450 core
// strokes: a point becomes a quad.

#include "strokes.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

in VertexRun {
    vec4 ends, corners, params;
    flat uvec4 indices;
    vec4 stroke;
} runs[];

void main() {
    Run run = Run(runs[0].ends, runs[0].corners, runs[0].params, runs[0].indices, runs[0].stroke);
    if (is_left_out(run)) return;
    Axes axes = axes_of(run);
    for (uint i = 0u; i < 4u; ++i) {
        set_corner(run, axes, i >> 1, (i & 1u) == 0u ? 1.0 : -1.0);
        set_run(run, axes);
        EmitVertex();
    }
    EndPrimitive();
}
