#pragma once

#include <cstdint>

namespace lineatlas {

/// A share from 0 to 1 that looks random but belongs to the path; the same as in filter.cl.
float path_share(std::uint32_t path);

} // namespace lineatlas
