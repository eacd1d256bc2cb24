/* Meshlets: the form in which kernels draw clusters. Each meshlet has a list of its vertices, so
 * that each vertex is transformed once, and its triangles as places in that list. Valid as OpenCL C
 * 1.2 and as C++20.
 */
#ifndef LINEATLAS_MESHLET_TABLE_H
#define LINEATLAS_MESHLET_TABLE_H

#include "segment_table.h"

/* Lists are filled up to a multiple of this: kernels read them in vectors. */
#define LA_MESHLET_PADDING 16u
/* The most triangles and vertices of one meshlet. Places in its list of vertices are bytes. */
#define LA_MESHLET_TRIANGLES 64u
#define LA_MESHLET_VERTICES (3u * LA_MESHLET_TRIANGLES)

#ifndef __OPENCL_VERSION__
namespace lineatlas {
#endif

/* The triangles of the cluster of the same number. */
typedef struct Meshlet {
    la_uint vertices;     /* where its list begins; the list holds places in the vertex table */
    la_uint vertex_count; /* of the list */
    la_uint corners;      /* where its three rows begin: places in that list of first, second and
                             third corners, each row filled up */
    la_uint triangle_count;
} Meshlet;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(Meshlet) == 16);
} // namespace lineatlas
#endif

#endif
