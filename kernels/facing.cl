/* facing: which triangles show their front to the eye.
 *
 * One work-item per triangle. The facing is computed once per triangle and not once per edge, so
 * that the edges of a triangle agree and silhouettes of a closed mesh close (§3.1, §4.1). */

#include "kernels.h"
#include "shared/clipping.h"

/* front[i]: 1 if triangle i is counter-clockwise as seen from the eye, else 0. */
KERNEL(facing, FacingParameters) {
    const uint i = (uint)get_global_id(0);
    if (i >= args.count) return;
    const float3 a = vload3(triangles[3 * i], vertices);
    const float3 b = vload3(triangles[3 * i + 1], vertices);
    const float3 c = vload3(triangles[3 * i + 2], vertices);
    front[i] = faces_eye(a, b, c, to_float4(args.eye)) ? 1 : 0;
}
