#version 450 core
// layer: one triangle that covers the viewport, and where its pixels lie in the layer.

uniform vec4 part; // of the layer: size and lower left corner, as shares of it

out vec2 place;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);
    place = 2.0 * corner * part.xy + part.zw;
}
