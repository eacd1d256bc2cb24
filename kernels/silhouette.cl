/* silhouette: which candidates are silhouettes in this frame (§3.1, §4.1).
 *
 * One work-item per candidate that may be a silhouette, except contours, which `contour` numbers.
 */

#include "shared/silhouette.h"

/* numbers[i]: 1 if candidate i is a silhouette, else 0. The scan turns them into numbers of the
 * silhouettes. */
KERNEL(silhouette, SilhouetteParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    __global const Segment* candidate = segments + args.first + i;
    numbers[i] = is_silhouette(candidate->face_a, candidate->face_b, front);
}

/* Lists the silhouettes that `numbers` numbers. chosen[n]: the candidate that silhouette n is, or
 * LA_NO_SILHOUETTE if there is room for more of them. total: how many there are. positions: a place
 * per candidate, emptied for `chain`. One work-item per candidate, contours too. */
KERNEL(silhouette_list, SilhouetteParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const uint c = i < args.replaced ? i : args.contours + (i - args.replaced);
    const uint n = numbers[i];
    positions[c] = 0;
    if (numbers[i + 1] != n && n < args.capacity) chosen[n] = c;
    if (i >= numbers[args.count] && i < args.capacity) chosen[i] = LA_NO_SILHOUETTE;
    if (i == 0) total[0] = numbers[args.count];
}
