#version 450 core
// spine, vertex-shader form: one instance of a four-cornered strip per segment; one that is not drawn
// goes behind the camera (§3.1).

#include "spine.glsl"

layout(location = 0) in uvec4 ends_and_faces;
layout(location = 1) in uint tag;

noperspective out vec2 local;
flat out vec4 stroke_p, stroke_q;
flat out vec2 stroke_clipped;
flat out uvec2 own_faces;

void main() {
    Stroke stroke = make_stroke(ends_and_faces.xy, ends_and_faces.zw, tag);
    local = vec2(0.0);
    gl_Position = stroke.drawn ? stroke_corner(stroke, uint(gl_VertexID), local)
                               : vec4(0.0, 0.0, -2.0, 1.0);
    stroke_p = stroke.p;
    stroke_q = stroke.q;
    stroke_clipped = stroke.clipped;
    own_faces = stroke.own_faces;
}
