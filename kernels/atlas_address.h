/* Eq. 2, as an index into rows of `pitch` texels of which the first `width` can start a segment:
 * wrapped if width equals pitch, else with a gutter. Sample j of a segment is at the segment's
 * address + j. The host's twin is AtlasLayout::address. */
#ifndef LINEATLAS_ATLAS_ADDRESS_H
#define LINEATLAS_ATLAS_ADDRESS_H

static uint atlas_address(const uint s, const uint width, const uint pitch) {
    return s / width * pitch + s % width;
}

#endif
