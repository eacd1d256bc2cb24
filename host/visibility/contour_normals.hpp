#pragma once

#include <cstdint>
#include <memory>

#include "line_tables.hpp"

namespace lineatlas {

/// Normals of contours, computed anew if positions have changed.
class ContourNormals {
  public:
    /// Says that positions have changed. Then find() must follow before anything moves. Does
    /// nothing for lines without contours.
    void expect(compute::Stages& stages, const LineTables& lines, std::uint32_t triangle_count);
    /// Computes the normals that are expected.
    void find(compute::Stages& stages, const LineTables& lines);
    /// Call if the places of corners in tables change, or the device.
    void forget() {
        offsets_.reset();
        places_.reset();
    }

  private:
    std::unique_ptr<compute::Buffer> offsets_, places_; ///< those of CornerPlaces
    bool are_old_ = false;
};

} // namespace lineatlas
