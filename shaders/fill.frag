#version 450 core
// fill: the colour of the triangle; LIT: in the light of a distant lamp; SMOOTH: by the normals of
// its corners, where it is one of a smooth surface.

uniform usamplerBuffer color_indices; // per triangle
uniform samplerBuffer colors;         // alpha 0: none
uniform bool has_colors;
uniform vec4 plain_color; // of triangles that have none

flat in uint first_triangle;

layout(location = 0) out vec4 picture;

vec4 triangle_color() {
    if (!has_colors) return plain_color;
    int triangle = int(first_triangle) + gl_PrimitiveID;
    vec4 color = texelFetch(colors, int(texelFetch(color_indices, triangle).x));
    return color.a > 0.0 ? color : plain_color;
}

#ifdef LIT
uniform vec4 light;    // direction to the lamp, in eye space
uniform float ambient; // light that is everywhere
uniform float steps;   // number of shades; 0: smooth

in vec3 eye_position;

#ifdef SMOOTH
const uint no_surface = 0xFFFFFFFFu;   // LA_NO_SURFACE
uniform usamplerBuffer smooth_corners; // per triangle: of normals
uniform usamplerBuffer normals;        // a vertex and its normal, as the bits of floats
uniform samplerBuffer vertices;
uniform mat4 clip_from_world;
uniform mat4 eye_from_normal; // of directions
uniform vec4 tile;
uniform vec2 viewport; // size

// A corner in clip space, with this pixel in the middle: little is lost where triangles are small.
vec2 corner_about_pixel(uint vertex) {
    vec4 clip = clip_from_world * vec4(texelFetch(vertices, int(vertex)).xyz, 1.0);
    vec2 at = gl_FragCoord.xy / viewport * 2.0 - 1.0;
    return clip.xy * tile.xy + clip.w * (tile.zw - at);
}

float cross_of(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// As smooth_shade() of fill.cl; `face_normal` looks at the eye.
vec3 smooth_normal(uvec3 own, vec3 face_normal) {
    vec2 at[3];
    vec3 normal[3];
    for (int k = 0; k < 3; ++k) {
        uvec4 corner = texelFetch(normals, int(own[k]));
        at[k] = corner_about_pixel(corner.x);
        normal[k] = mat3(eye_from_normal) * uintBitsToFloat(corner.yzw);
    }
    vec3 part = vec3(cross_of(at[1], at[2]), cross_of(at[2], at[0]), cross_of(at[0], at[1]));
    part = max(part * (part.x + part.y + part.z < 0.0 ? -1.0 : 1.0), 0.0);
    vec3 sum = normal[0] * part.x + normal[1] * part.y + normal[2] * part.z;
    return dot(face_normal, normal[0] + normal[1] + normal[2]) < 0.0 ? -sum : sum;
}
#endif

float shade() {
    // Both derivatives lie in the face. Their cross product looks at the eye, whichever way the triangle
    // is wound.
    vec3 normal = cross(dFdx(eye_position), dFdy(eye_position));
#ifdef SMOOTH
    uvec3 own = texelFetch(smooth_corners, int(first_triangle) + gl_PrimitiveID).xyz;
    if (own.x != no_surface) normal = smooth_normal(own, normal);
#endif
    float lambert = max(0.0, dot(normal, light.xyz) / max(length(normal), 1e-30));
    if (steps > 0.0) lambert = min(floor(lambert * steps), steps - 1.0) / (steps - 1.0);
    // Light adds up linearly, but colours are coded for the screen.
    return pow(mix(ambient, 1.0, lambert), 1.0 / 2.2);
}
#else
float shade() { return 1.0; }
#endif

void main() { picture = vec4(triangle_color().rgb * shade(), 1.0); }
