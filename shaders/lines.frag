#version 450 core
// lines: one colour, premultiplied.

uniform vec4 color;

layout(location = 0) out vec4 picture;

void main() { picture = vec4(color.rgb * color.a, color.a); }
