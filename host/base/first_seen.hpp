#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas {

/// A hash of three numbers in their order, for FirstSeen.
inline std::uint32_t hash_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint64_t h =
        a * 0x9E3779B97F4A7C15ULL ^ (std::uint64_t{b} << 32U | c) * 0xC2B2AE3D27D4EB4FULL;
    h ^= h >> 29U;
    h *= 0xBF58476D1CE4E5B9ULL;
    return static_cast<std::uint32_t>(h >> 32U);
}

/// A hash of a position. Equal positions have equal hashes, -0 and 0 too.
inline std::uint32_t hash_of(glm::vec3 at) {
    at += 0.0F; // -0 becomes 0
    return hash_of(std::bit_cast<std::uint32_t>(at.x), std::bit_cast<std::uint32_t>(at.y),
                   std::bit_cast<std::uint32_t>(at.z));
}

/// An open-addressing table from keys to the index of their first appearance.
class FirstSeen {
  public:
    /// Makes a table for at most `expected` keys.
    explicit FirstSeen(std::size_t expected)
        : slots_(std::bit_ceil(std::max<std::size_t>(16, expected * 2)), empty_slot) {}

    /// The most keys that it may be given.
    std::size_t room() const { return slots_.size() / 2; }

    /// The index kept for a key; `fresh` if the key is new. is_key(index): whether a kept index has
    /// the key.
    template <class IsKey>
    std::uint32_t find_or_add(std::uint32_t fresh, std::uint32_t hash, const IsKey& is_key) {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = hash & mask;; slot = (slot + 1) & mask) {
            if (slots_[slot] == empty_slot) return slots_[slot] = fresh;
            if (is_key(slots_[slot])) return slots_[slot];
        }
    }

    /// The index kept for a key; nothing if there is none.
    template <class IsKey>
    std::optional<std::uint32_t> find(std::uint32_t hash, const IsKey& is_key) const {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = hash & mask; slots_[slot] != empty_slot; slot = (slot + 1) & mask)
            if (is_key(slots_[slot])) return slots_[slot];
        return std::nullopt;
    }

  private:
    static constexpr std::uint32_t empty_slot = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> slots_;
};

} // namespace lineatlas
