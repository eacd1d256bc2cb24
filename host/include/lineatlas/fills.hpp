#pragma once

#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/device_options.hpp"
#include "lineatlas/export.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/progress.hpp"
#include "lineatlas/style.hpp"
#include "lineatlas/vector.hpp"

/// @file
/// Fills of drawings as paths: areas of what is seen, one for each part and colour.
/// @code{.cpp}
/// LineVisibility visibility{lines};
/// VectorDrawing drawing = make_vector_drawing(lines, camera, visibility.find(camera), style);
/// drawing.fills = find_fills(lines, camera, {.mode = FillMode::lambert});
/// @endcode

namespace lineatlas {

/// Returns the areas that `camera` sees of the triangles of a line set, one for each part and
/// colour: VectorDrawing::fills. Colours are those of pictures, for `fill` and for the colours of
/// LineSet::colors. On smooth surfaces they differ: pictures light by corner normals, areas by
/// triangles. The areas cover what the triangles cover, without gaps, and do not overlap;
/// their borders are where edges of the triangles and LineKind::intersection lines are seen, to
/// 0.002 pixels. Empty for FillMode::none. Throws as LineVisibility and its find() do,
/// UsageError for a fill that no style can have, and Cancelled if `progress` returns false: it is
/// called before each stage, and within long ones.
LINEATLAS_API std::vector<VectorFill> find_fills(const LineSet& lines, const Camera& camera,
                                                 const Fill& fill, const DeviceOptions& device = {},
                                                 const Progress& progress = {});

} // namespace lineatlas
