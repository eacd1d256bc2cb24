#pragma once

#include <cstdint>
#include <memory>

#include "line_tables.hpp"

namespace lineatlas {

/// Normals of contours, computed anew if positions have changed.
class ContourNormals {
  public:
    /// Positions have changed: find() is to come before anything moves. Nothing for lines without
    /// contours.
    void expect(compute::Stages& stages, const LineTables& lines, std::uint32_t triangle_count);
    /// Finds those that are expected.
    void find(compute::Stages& stages, const LineTables& lines);
    /// Where corners stand changes, or the device.
    void forget() {
        offsets_.reset();
        places_.reset();
    }

  private:
    std::unique_ptr<compute::Buffer> offsets_, places_; ///< as CornerPlaces
    bool are_old_ = false;
};

} // namespace lineatlas
