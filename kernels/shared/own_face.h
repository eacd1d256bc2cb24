/* What `project_clip` and the spine pass tell probes about the two faces beside a line. */
#ifndef LINEATLAS_OWN_FACE_H
#define LINEATLAS_OWN_FACE_H

#include "shared/constants.h"
#include "shared/language.h"

/* Stands in place of both descriptions, or of both numbers, of a line that lies within its part
 * (LA_TAG_BURIED). */
#define LA_OWN_BURIED 0xFFFFFFFFu
/* Stands in place of the side that is outside, for such a line. */
#define LA_OUTSIDE_NOWHERE 2.0f

/* The outside of a fold, a silhouette whose two faces lie on one side of the line: 1 if it is to
 * the left, -1 if to the right, 0 if there is no fold. own_a, own_b: descriptions of the faces
 * (describe_own_face in clipping.h). */
FUNCTION float outside_of_fold(const uint own_a, const uint own_b) {
    const float a = as_float(own_a & 0xFFFF0000u), b = as_float(own_b & 0xFFFF0000u);
    if (fmax(a, b) > LA_HEIGHT_LIMIT) return 0.0f; /* the line runs within a face */
    return a > 0.0f && b > 0.0f ? -1.0f : a < 0.0f && b < 0.0f ? 1.0f : 0.0f;
}

/* Stands in place of a description, for probes that know surfaces. Holds the face's number, and
 * whether the line is the border of a fold with its outside to this side: for own_a the left, for
 * own_b the right. */
FUNCTION uint numbered_face(const uint number, const bool is_outside) {
    return (number & LA_NO_NUMBER) | (is_outside ? 0x80000000u : 0u);
}

/* As outside_of_fold(), for numbered faces. */
FUNCTION float outside_of_numbered(const uint own_a, const uint own_b) {
    return (own_a & 0x80000000u) != 0u ? 1.0f : (own_b & 0x80000000u) != 0u ? -1.0f : 0.0f;
}

#endif
