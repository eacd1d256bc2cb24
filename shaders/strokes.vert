#version 450 core
// strokes: one point per run.

layout(location = 0) in vec4 ends;
layout(location = 1) in vec4 corners;
layout(location = 2) in vec4 params;
layout(location = 3) in uvec4 indices;
layout(location = 4) in vec4 stroke;

out VertexRun {
    vec4 ends, corners, params;
    flat uvec4 indices;
    vec4 stroke;
} run;

void main() {
    run.ends = ends;
    run.corners = corners;
    run.params = params;
    run.indices = indices;
    run.stroke = stroke;
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
