// What a pen leaves on the paper, shared by the stroke and spine passes.

uniform vec4 color;        // RGB and opacity
uniform sampler2D pen;     // coverage; u along the stroke, v across it
uniform float pen_repeat;  // pixels along the stroke that one repeat covers; 0: a solid mark

// A third of the probes make a full stroke. On a smooth silhouette half of every pixel is surface, so
// half of the probes is all that can see the line.
const float visibility_gain = 3.0;

float stroke_visibility(float alpha) { return min(1.0, visibility_gain * alpha); }

// Antialiased coverage at a distance from the spine, pixels.
float stroke_coverage(float distance_px, float half_width) {
    return clamp(half_width + 0.5 - distance_px, 0.0, min(1.0, 2.0 * half_width));
}

// The pen's texture at an arc length and a distance to the left, pixels.
float pen_mark(float arc, float across, float half_width) {
    if (pen_repeat <= 0.0) return 1.0;
    return texture(pen, vec2(arc / pen_repeat, across * 0.5 / max(half_width, 0.5) + 0.5)).r;
}
