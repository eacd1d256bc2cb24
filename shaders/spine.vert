#version 450 core
// spine: one point per segment of the segment table.

layout(location = 0) in uvec4 ends_and_faces;
layout(location = 1) in uint tag;

out VertexSegment {
    flat uvec4 ends_and_faces;
    flat uint tag;
} segment;

void main() {
    segment.ends_and_faces = ends_and_faces;
    segment.tag = tag;
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
