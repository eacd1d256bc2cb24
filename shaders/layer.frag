#version 450 core
// layer: the pixel of a picture that kernels drew.

uniform sampler2D pixels; // premultiplied; the nearest

in vec2 place;

layout(location = 0) out vec4 picture;

// Sampled, not fetched: llvmpipe takes a quarter less time.
void main() { picture = texture(pixels, place); }
