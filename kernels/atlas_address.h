/* Where the samples of a segment lie in the atlas. AtlasLayout::address is the same on the host. */
#ifndef LINEATLAS_ATLAS_ADDRESS_H
#define LINEATLAS_ATLAS_ADDRESS_H

#include "kernels.h"

/* Eq. 2, as an index into rows of texels: wrapped if width equals pitch, else with a gutter. Sample
 * j of a segment is at the address of its first sample s, + j. */
static uint atlas_address(const AtlasRows rows, const uint s) {
    return s / rows.width * rows.pitch + s % rows.width;
}

/* Whether a segment of l samples from s on has any, and the atlas has room for them. */
static bool is_in_atlas(const AtlasRows rows, const uint s, const uint l) {
    return l != 0 && l <= rows.capacity && s <= rows.capacity - l;
}

#endif
