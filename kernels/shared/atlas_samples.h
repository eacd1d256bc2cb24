/* Which samples the atlas has. Sample j of a segment stands at s + j, where s is the segment's
 * offset. */
#ifndef LINEATLAS_ATLAS_SAMPLES_H
#define LINEATLAS_ATLAS_SAMPLES_H

#include "kernels.h"

/* True if a segment has samples (l is not 0) and the atlas has room for those from s up to s + l.
 */
static bool is_in_atlas(const uint capacity, const uint s, const uint l) {
    return l != 0 && l <= capacity && s <= capacity - l;
}

#endif
