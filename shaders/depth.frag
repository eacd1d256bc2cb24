#version 450 core
// depth: writes depth alone. NUMBERED: also the triangle's number.

#ifdef NUMBERED
flat in uint first_triangle;

layout(location = 0) out uint number;

void main() { number = first_triangle + uint(gl_PrimitiveID); }
#else
void main() {}
#endif
