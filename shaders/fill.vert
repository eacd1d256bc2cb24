#version 450 core
// fill: the vertices of the triangles. LIT: also their places in eye space, for the light.

layout(location = 0) in vec3 position;
layout(location = 1) in uint first_index; // of the range that is drawn

uniform mat4 clip_from_world;
uniform vec4 tile = vec4(1.0, 1.0, 0.0, 0.0); // tile_transform(): the whole picture

#ifdef LIT
uniform mat4 eye_from_world;
out vec3 eye_position;
#endif
flat out uint first_triangle;

void main() {
    vec4 clip = clip_from_world * vec4(position, 1.0);
    gl_Position = vec4(clip.xy * tile.xy + clip.w * tile.zw, clip.zw);
    first_triangle = first_index / 3u;
#ifdef LIT
    eye_position = (eye_from_world * vec4(position, 1.0)).xyz;
#endif
}
