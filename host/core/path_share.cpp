#include "path_share.hpp"

namespace lineatlas {

float path_share(std::uint32_t path) {
    std::uint32_t h = path * 0x9E3779B1U;
    h ^= h >> 16U;
    h *= 0x85EBCA6BU;
    h ^= h >> 13U;
    return static_cast<float>(h >> 8U) * (1.0F / 16777216.0F);
}

} // namespace lineatlas
