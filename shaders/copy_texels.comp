#version 450 core
// copy_texels: copies a part of a texture, row by row, to its place in a buffer that holds the whole. One
// invocation per texel. NUMBERS: the texture holds whole numbers, else floats.

layout(local_size_x = 16, local_size_y = 16) in;

#ifdef NUMBERS
uniform usampler2D texels;
#else
uniform sampler2D texels;
#endif
uniform ivec4 part; // lowest texel, and how many
uniform int row;    // texels

layout(std430, binding = 0) writeonly buffer Copied { uint copied[]; };

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, part.zw))) return;
    at += part.xy;
#ifdef NUMBERS
    copied[at.y * row + at.x] = texelFetch(texels, at, 0).r;
#else
    copied[at.y * row + at.x] = floatBitsToUint(texelFetch(texels, at, 0).r);
#endif
}
