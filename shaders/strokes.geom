#version 450 core
// strokes, geometry-shader form: a point becomes a quad.

#include "strokes.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

in VertexRun {
    vec4 ends, corners, params;
    flat uvec4 indices;
    vec4 stroke;
} runs[];

noperspective out vec2 local;
flat out vec4 run_ends;
flat out vec4 run_corners;
flat out vec4 run_params;
flat out uvec4 run_indices;
flat out vec4 run_stroke;

void main() {
    Run run = Run(runs[0].ends, runs[0].corners, runs[0].params, runs[0].indices, runs[0].stroke);
    for (uint i = 0u; i < 4u; ++i) {
        Corner corner = stroke_corner(run, i >> 1, (i & 1u) == 0u ? 1.0 : -1.0);
        local = corner.local;
        run_ends = run.ends;
        run_corners = run.corners;
        run_params = run.params;
        run_indices = run.indices;
        run_stroke = run.stroke;
        gl_Position = corner.position;
        EmitVertex();
    }
    EndPrimitive();
}
