#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace lineatlas::compute {

/// 128 bits that tell contents apart by accident, not against an attacker.
class ContentHash {
  public:
    /// The hash of the content so far followed by `bytes`.
    ContentHash with(std::span<const std::byte> bytes) const;

    /// 32 hexadecimal digits.
    std::string text() const;

    bool operator==(const ContentHash&) const = default;

  private:
    void add(std::uint64_t word);

    std::uint64_t lanes_[2] = {0x9E3779B97F4A7C15U, 0xD1B54A32D192ED03U};
};

} // namespace lineatlas::compute
