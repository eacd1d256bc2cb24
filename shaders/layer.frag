#version 450 core
// layer: the pixel of a picture that was drawn elsewhere. MEAN: the mean of its texels, rounded as fill.cl does.

uniform sampler2D pixels; // premultiplied

layout(location = 0) out vec4 picture;

#ifdef MEAN
uniform int scale;    // texels per pixel and axis
uniform float steps;  // the largest value of a channel
uniform ivec2 origin; // of the layer in the framebuffer

void main() {
    ivec2 first = (ivec2(gl_FragCoord.xy) - origin) * scale;
    uvec4 sum = uvec4(0u);
    for (int y = 0; y < scale; ++y) {
        for (int x = 0; x < scale; ++x) sum += uvec4(round(steps * texelFetch(pixels, first + ivec2(x, y), 0)));
    }
    uint count = uint(scale * scale);
    picture = vec4((sum + count / 2u) / count) / steps;
}
#else
in vec2 place;

// Sampled, not fetched: llvmpipe takes a quarter less time.
void main() { picture = texture(pixels, place); }
#endif
