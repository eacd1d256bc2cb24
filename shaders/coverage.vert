#version 450 core
// strokes, compute form: a tile of the picture that has any, as an instance of a strip.

uniform usamplerBuffer shown; // per tile 1 if it has strokes
uniform int first_shown;      // of the layer
uniform ivec4 tiles;          // the first in the whole picture, and how many
uniform ivec4 part;           // what is drawn of the picture: its first pixel and size

#include "stroke_tile.h"

void main() {
    int t = gl_InstanceID;
    ivec2 tile = tiles.xy + ivec2(t % tiles.z, t / tiles.z);
    ivec2 corner = ivec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 pixel = vec2(clamp((tile + corner) * LA_STROKE_TILE - part.xy, ivec2(0), part.zw));
    bool any = texelFetch(shown, first_shown + t).r != 0u;
    gl_Position = vec4(any ? pixel / vec2(part.zw) * 2.0 - 1.0 : vec2(0.0), 0.0, 1.0);
}
