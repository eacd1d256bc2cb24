/* What `project_clip` and the spine pass tell probes of the two faces beside a line. */
#ifndef LINEATLAS_OWN_FACE_H
#define LINEATLAS_OWN_FACE_H

#include "constants.h"
#include "language.h"

/* In place of both descriptions, or numbers: the line lies within its part (LA_TAG_BURIED). */
#define LA_OWN_BURIED 0xFFFFFFFFu
/* Of such a line, in place of the side that is outside. */
#define LA_OUTSIDE_NOWHERE 2.0f

/* Of a fold, both faces on one side of the line (a silhouette), given their descriptions
 * (describe_own_face in clipping.h): 1 if the left is outside, -1 if the right is; else 0. */
FUNCTION float outside_of_fold(const uint own_a, const uint own_b) {
    const float a = as_float(own_a & 0xFFFF0000u), b = as_float(own_b & 0xFFFF0000u);
    if (fmax(a, b) > LA_HEIGHT_LIMIT) return 0.0f; /* the line runs within a face */
    return a > 0.0f && b > 0.0f ? -1.0f : a < 0.0f && b < 0.0f ? 1.0f : 0.0f;
}

/* In place of a description, for probes that know surfaces: the face's number, and whether the line
 * is the border of a fold whose outside is to this side: of own_a to the left, of own_b to the
 * right. */
FUNCTION uint numbered_face(const uint number, const bool is_outside) {
    return (number & LA_NO_NUMBER) | (is_outside ? 0x80000000u : 0u);
}

/* The same side, of numbered faces. */
FUNCTION float outside_of_numbered(const uint own_a, const uint own_b) {
    return (own_a & 0x80000000u) != 0u ? 1.0f : (own_b & 0x80000000u) != 0u ? -1.0f : 0.0f;
}

#endif
