#include "content_hash.hpp"

#include <algorithm>
#include <cstring>

namespace lineatlas::compute {

// Each step of a lane is a bijection of its state and, for a given state, of the word. So a change
// within one word of the content always changes the hash.
void ContentHash::add(std::uint64_t word) {
    constexpr std::uint64_t odd[2] = {0xBF58476D1CE4E5B9U, 0x94D049BB133111EBU};
    for (std::size_t i = 0; i < 2; ++i) {
        lanes_[i] = (lanes_[i] ^ word) * odd[i];
        lanes_[i] ^= lanes_[i] >> 29U;
    }
}

ContentHash ContentHash::with(std::span<const std::byte> bytes) const {
    ContentHash result = *this;
    result.add(bytes.size()); // keeps "ab", "c" apart from "a", "bc"
    while (!bytes.empty()) {
        std::uint64_t word = 0;
        const std::size_t taken = std::min(bytes.size(), sizeof(word));
        std::memcpy(&word, bytes.data(), taken);
        result.add(word);
        bytes = bytes.subspan(taken);
    }
    return result;
}

std::string ContentHash::text() const {
    constexpr char digits[] = "0123456789abcdef";
    std::string result;
    for (const std::uint64_t lane : lanes_) {
        for (unsigned shift = 64; shift > 0; shift -= 4) {
            result += digits[(lane >> (shift - 4)) & 0xFU];
        }
    }
    return result;
}

} // namespace lineatlas::compute
