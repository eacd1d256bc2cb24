#version 450 core
// spine: a segment becomes a stroke, or nothing (§3.1).

#include "spine.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

in VertexSegment {
    flat uvec4 ends_and_faces;
    flat uint tag;
} segments[];

noperspective out vec2 local;
flat out vec4 stroke_p, stroke_q;
flat out vec2 stroke_clipped;
flat out uvec2 own_faces;

void main() {
    Stroke stroke = make_stroke(segments[0].ends_and_faces.xy, segments[0].ends_and_faces.zw,
                                segments[0].tag);
    if (!stroke.drawn) return;
    for (uint i = 0u; i < 4u; ++i) {
        gl_Position = stroke_corner(stroke, i, local);
        stroke_p = stroke.p;
        stroke_q = stroke.q;
        stroke_clipped = stroke.clipped;
        own_faces = stroke.own_faces;
        EmitVertex();
    }
    EndPrimitive();
}
