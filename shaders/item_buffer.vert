#version 450 core
// item_buffer: the ends of the lines that are drawn in this frame, two vertices per line.

layout(location = 0) in vec3 position; // in normalised device coordinates

// The same line must rasterise alike in every layer.
invariant gl_Position;
flat out uint line_id;

void main() {
    gl_Position = vec4(position, 1.0);
    line_id = uint(gl_VertexID) / 2u + 1u;
}
