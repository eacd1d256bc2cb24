#version 450 core
// paper: a factor for every pixel, less than 1 where the paper lies low.

uniform sampler2D depth; // of the paper's surface, repeated over the picture
uniform float grain;
uniform vec2 corner;     // of the part of the picture that is drawn, pixels

layout(location = 0) out vec4 factor;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy + corner) & (textureSize(depth, 0) - 1);
    factor = vec4(vec3(1.0 - grain * texelFetch(depth, texel, 0).x), 1.0);
}
