/* silhouette: which candidates are silhouettes in this frame (§3.1, §4.1).
 *
 * One work-item per candidate that may be a silhouette, except contours, which `contour` numbers.
 * */

#include "silhouette.h"

/* numbers[i]: 1 if it is one, else 0. Scanned, they number the silhouettes. */
KERNEL(silhouette, SilhouetteParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    __global const Segment* candidate = segments + args.first + i;
    numbers[i] = is_silhouette(candidate->face_a, candidate->face_b, front);
}

/* What they number. chosen[n]: the candidate that silhouette n is. positions: of all candidates,
 * emptied for `chain`. One work-item per candidate that may be one, contours too. */
KERNEL(silhouette_list, SilhouetteParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const uint c = i < args.replaced ? i : args.contours + (i - args.replaced);
    positions[c] = 0;
    if (numbers[i + 1] != numbers[i]) chosen[numbers[i]] = c;
}
