#version 450 core
// strokes, compute form: lays each pen's colour over a pixel by the coverage that kernels found.

const int most_layers = 8;

uniform samplerBuffer coverage;    // of each layer, row by row
uniform int pitch;                 // from layer to layer
uniform ivec2 origin;              // where in the framebuffer the coverage begins
uniform int row;                   // pixels
uniform vec4 colors[most_layers];  // RGB

flat in uint layers_here;

layout(location = 0) out vec4 picture;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - origin;
    int address = pixel.y * row + pixel.x;
    vec4 sum = vec4(0.0);
    for (uint left = layers_here; left != 0u; left &= left - 1u) {
        int layer = findLSB(left);
        float covered = texelFetch(coverage, layer * pitch + address).r;
        sum = sum * (1.0 - covered) + vec4(colors[layer].rgb * covered, covered);
    }
    if (sum.a == 0.0) discard;
    picture = sum;
}
