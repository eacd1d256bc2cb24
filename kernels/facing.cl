/* facing: which triangles show their front to the eye.
 *
 * One work-item per triangle. Computed once per triangle and not once per edge, so that the edges
 * of a triangle agree and silhouettes of a closed mesh close (§3.1, §4.1). */

#pragma OPENCL FP_CONTRACT OFF

/* eye: homogeneous; w is 1 for a point, 0 for the direction towards a parallel viewer.
 * front[i]: 1 if triangle i is counter-clockwise as seen from the eye, else 0. */
__kernel void facing(__global const float* restrict vertices,
                     __global const uint* restrict triangles, const uint count, const float4 eye,
                     __global uchar* restrict front) {
    const uint i = (uint)get_global_id(0);
    if (i >= count) return;
    const float3 a = vload3(triangles[3 * i], vertices);
    const float3 ab = vload3(triangles[3 * i + 1], vertices) - a;
    const float3 ac = vload3(triangles[3 * i + 2], vertices) - a;
    const float3 to_eye = eye.xyz - a * eye.w;
    const float nx = ab.y * ac.z - ab.z * ac.y;
    const float ny = ab.z * ac.x - ab.x * ac.z;
    const float nz = ab.x * ac.y - ab.y * ac.x;
    front[i] = (nx * to_eye.x + ny * to_eye.y) + nz * to_eye.z > 0.0f ? 1 : 0;
}
