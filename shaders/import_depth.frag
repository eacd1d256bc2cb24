#version 450 core
// import_depth: the values of a program's own depth buffer as window depth of the standard camera.

uniform sampler2D depth;
uniform ivec2 first;     // texel of the depth buffer at the lower left corner
uniform float reference; // the value at window depth 0
uniform float scale;

layout(location = 0) out float window_depth;

void main() {
    float value = texelFetch(depth, ivec2(gl_FragCoord.xy) + first, 0).r;
    window_depth = (value - reference) * scale;
}
