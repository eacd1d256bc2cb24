/* Which candidates are silhouettes: what `silhouette` and `project_clip` share. */
#ifndef LINEATLAS_SILHOUETTE_H
#define LINEATLAS_SILHOUETTE_H

#include "kernels.h"

/* Whether the eye sees one of two faces and not the other. */
static bool is_silhouette(const uint face_a, const uint face_b, __global const uchar* front) {
    const uchar flipped = (face_b & LA_FACE_FLIPPED) != 0 ? 1 : 0;
    return front[face_a] != (front[face_b & LA_FACE_INDEX] ^ flipped);
}

#endif
