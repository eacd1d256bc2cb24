#version 450 core
// depth: the vertices of the triangles. NUMBERED: also the number of the first triangle of the range.

layout(location = 0) in vec3 position;
uniform mat4 clip_from_world;
uniform vec4 tile = vec4(1.0, 1.0, 0.0, 0.0); // tile_transform(): the whole picture

#ifdef NUMBERED
layout(location = 1) in uint first_index; // of the range that is drawn
flat out uint first_triangle;
#endif

void main() {
    vec4 clip = clip_from_world * vec4(position, 1.0);
    gl_Position = vec4(clip.xy * tile.xy + clip.w * tile.zw, clip.zw);
#ifdef NUMBERED
    first_triangle = first_index / 3u;
#endif
}
