/* Which samples the atlas has: sample j of a segment is the one at its offset s, + j. */
#ifndef LINEATLAS_ATLAS_SAMPLES_H
#define LINEATLAS_ATLAS_SAMPLES_H

#include "kernels.h"

/* Whether a segment of l samples from s on has any, and the atlas has room for them. */
static bool is_in_atlas(const uint capacity, const uint s, const uint l) {
    return l != 0 && l <= capacity && s <= capacity - l;
}

#endif
