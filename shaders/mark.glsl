// What a pen leaves on the paper, shared by the stroke and spine passes.

uniform vec4 color;        // RGB and opacity

#include "shared/constants.h"

// A third of the probes is enough for a full stroke. On a smooth silhouette the surface covers half of
// each pixel, so no more than half of the probes can see the line.
float stroke_visibility(float alpha) { return min(1.0, alpha * (255.0 / float(LA_FULLY_SHOWN))); }

// Antialiased coverage at a distance from the spine, pixels.
float stroke_coverage(float distance_px, float half_width) {
    return clamp(half_width + 0.5 - distance_px, 0.0, min(1.0, 2.0 * half_width));
}

// Coverage of a mark at an arc length and at a distance to the left, both in pixels. repeat: pixels along
// the stroke per repeat of the mark.
float mark_of(sampler2D mark, float repeat, float arc, float across, float half_width) {
    return texture(mark, vec2(arc / repeat, across * 0.5 / max(half_width, 0.5) + 0.5)).r;
}

// PEN_TEXTURE: the pen's mark is not solid.
#ifdef PEN_TEXTURE
uniform sampler2D pen;     // coverage; u along the stroke, v across it
uniform float pen_repeat;
float pen_mark(float arc, float across, float half_width) {
    return mark_of(pen, pen_repeat, arc, across, half_width);
}
#else
float pen_mark(float arc, float across, float half_width) { return 1.0; }
#endif
