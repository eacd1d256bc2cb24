#version 450 core
// depth: nothing but the depth, or, NUMBERED, the triangle's number too.

#ifdef NUMBERED
flat in uint first_triangle;

layout(location = 0) out uint number;

void main() { number = first_triangle + uint(gl_PrimitiveID); }
#else
void main() {}
#endif
