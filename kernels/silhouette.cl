/* silhouette: which candidates are silhouettes in this frame (§3.1, §4.1).
 *
 * One work-item per candidate that may be one. */

#include "silhouette.h"

/* numbers[i]: 1 if it is one, else 0. Scanned, they number the silhouettes. */
KERNEL(silhouette, SilhouetteParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    if (i >= args.replaced) {
        numbers[i] = contour_ends[2 * (i - args.replaced)] != LA_NO_VERTEX ? 1 : 0;
        return;
    }
    __global const Segment* candidate = segments + args.first + i;
    numbers[i] = is_silhouette(candidate->face_a, candidate->face_b, front);
}
