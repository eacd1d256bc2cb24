#version 450 core
// strokes, geometry-shader form: one point per visible run.

layout(location = 0) in vec4 ends;
layout(location = 1) in vec4 mitres;
layout(location = 2) in vec4 params;
layout(location = 3) in uvec4 indices;

out VertexRun {
    vec4 ends, mitres, params;
    flat uvec4 indices;
} run;

void main() {
    run.ends = ends;
    run.mitres = mitres;
    run.params = params;
    run.indices = indices;
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
