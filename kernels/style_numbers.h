/* The numbers of a style that kernels read: what a style file sets is what a kernel gets. Valid as
 * OpenCL C 1.2 and as C++20; includes no other header of kernels. */
#ifndef LINEATLAS_STYLE_NUMBERS_H
#define LINEATLAS_STYLE_NUMBERS_H

#ifdef __OPENCL_VERSION__
#define LA_BY_DEFAULT(value)
#else
#include <array>
#define LA_BY_DEFAULT(value) = value

namespace lineatlas {
#endif

/** Changes to visibility along each path (§4.5). Pixels; 0: off. In this order. */
typedef struct StrokeFilter {
    float fill_holes LA_BY_DEFAULT(0); /**< holes shorter than this are closed */
    float drop_runs LA_BY_DEFAULT(0);  /**< visible runs shorter than this are left out */
    float overshoot LA_BY_DEFAULT(0); /**< visible runs are longer by this at either end, beyond the
                                           path's too */
    /** Share of the overshoot that varies from path to path, 0 to 1; the same in every frame. */
    float overshoot_variation LA_BY_DEFAULT(0);
    float undershoot LA_BY_DEFAULT(0); /**< visible runs are shorter by this where something hides
                                            the line */
    float halo LA_BY_DEFAULT(0); /**< gap in the farther of two lines that cross, beside the nearer
                                      stroke */
} StrokeFilter;
#ifndef __OPENCL_VERSION__
/** Calls `each` with the members that are lengths: they grow with the picture. */
template <class Each>
void for_each_length(StrokeFilter& filter, const Each& each) {
    for (float* length : {&filter.fill_holes, &filter.drop_runs, &filter.overshoot,
                          &filter.undershoot, &filter.halo})
        each(*length);
}
#endif

/** Line density control (§4.5, Fig. 11). */
typedef struct Density {
    /** Pixels of line per pixel of the picture at most, averaged over a neighbourhood; 0: off. */
    float limit LA_BY_DEFAULT(0);
    /** Weight of each line kind (crease, boundary, material, silhouette, file, intersection,
     * section, hatching, ridge, valley, tangent, centre, trail), 0 to 1: lines of more weight stay
     * longer, then longer lines. */
#ifdef __OPENCL_VERSION__
    float priority[13];
#else
    std::array<float, 13> priority{0.5F, 0.6F, 0.5F, 1, 1, 0.5F, 1, 0.2F, 0.3F, 0.3F, 0.3F, 1, 1};
#endif
} Density;

#ifndef __OPENCL_VERSION__
} // namespace lineatlas
#endif

#endif
