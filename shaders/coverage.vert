#version 450 core
// strokes, compute form: one tile of the picture per instance, as a strip of two triangles. A tile without
// strokes shrinks to a point.

uniform usamplerBuffer shown; // per layer and tile: 1 if the layer has strokes there
uniform int layers;
uniform ivec4 tiles;          // the first tile in the whole picture, and how many across and up
uniform ivec4 part;           // the part of the picture that is drawn: its first pixel and size

#include "stroke_tile.h"

flat out uint layers_here; // a bit for each layer that has strokes in the tile

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
