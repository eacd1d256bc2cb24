#version 450 core
// atlas, raster form: one point per segment, straight from the clipped segment table (§4.2).

layout(location = 0) in vec4 p;
layout(location = 1) in vec4 q;
layout(location = 2) in uvec2 own_faces;
layout(location = 3) in uint offset;
layout(location = 4) in uint next_offset;

out VertexSegment {
    vec4 p, q;
    flat uvec2 own_faces;
    flat uvec2 range;  // offset s and sample count l
} segment;

void main() {
    segment.p = p;
    segment.q = q;
    segment.own_faces = own_faces;
    segment.range = uvec2(offset, next_offset - offset);
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
