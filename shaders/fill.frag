#version 450 core
// fill: the colour of the triangle. LIT: shaded by a distant lamp.

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

float shade() {
    // Both derivatives lie in the face. Their cross product looks at the eye, whichever way the triangle
    // is wound.
    vec3 normal = cross(dFdx(eye_position), dFdy(eye_position));
    float lambert = max(0.0, dot(normal, light.xyz) / max(length(normal), 1e-30));
    if (steps > 0.0) lambert = min(floor(lambert * steps), steps - 1.0) / (steps - 1.0);
    // Light adds up linearly, but colours are coded for the screen.
    return pow(mix(ambient, 1.0, lambert), 1.0 / 2.2);
}
#else
float shade() { return 1.0; }
#endif

void main() { picture = vec4(triangle_color().rgb * shade(), 1.0); }
