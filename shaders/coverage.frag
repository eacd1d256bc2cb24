#version 450 core
// strokes, compute form: a pen's colour where kernels have found strokes of it.

uniform samplerBuffer coverage; // of the layer, row by row
uniform ivec2 origin;           // where in the framebuffer it begins
uniform int row;                // pixels
uniform vec4 color;             // RGB

layout(location = 0) out vec4 picture;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - origin;
    float covered = texelFetch(coverage, pixel.y * row + pixel.x).r;
    if (covered == 0.0) discard;
    picture = vec4(color.rgb * covered, covered);
}
