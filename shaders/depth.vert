#version 450 core
// depth: the triangles, for their depth alone.

layout(location = 0) in vec3 position;
uniform mat4 clip_from_world;
uniform vec4 tile = vec4(1.0, 1.0, 0.0, 0.0); // tile_transform(): the whole picture

void main() {
    vec4 clip = clip_from_world * vec4(position, 1.0);
    gl_Position = vec4(clip.xy * tile.xy + clip.w * tile.zw, clip.zw);
}
