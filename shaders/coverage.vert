#version 450 core
// strokes, compute form: a tile of the picture that has any, as an instance of a strip.

uniform usamplerBuffer shown; // of each layer per tile 1 if it has strokes
uniform int layers;
uniform ivec4 tiles;          // the first in the whole picture, and how many
uniform ivec4 part;           // what is drawn of the picture: its first pixel and size

#include "stroke_tile.h"

flat out uint layers_here; // a bit for each that has strokes in the tile

void main() {
    int t = gl_InstanceID;
    ivec2 tile = tiles.xy + ivec2(t % tiles.z, t / tiles.z);
    ivec2 corner = ivec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 pixel = vec2(clamp((tile + corner) * LA_STROKE_TILE - part.xy, ivec2(0), part.zw));
    layers_here = 0u;
    for (int i = 0; i < layers; ++i)
        layers_here |= texelFetch(shown, i * tiles.z * tiles.w + t).r << uint(i);
    gl_Position = vec4(layers_here != 0u ? pixel / vec2(part.zw) * 2.0 - 1.0 : vec2(0.0), 0.0, 1.0);
}
