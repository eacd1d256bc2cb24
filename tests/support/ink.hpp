#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lineatlas/io.hpp"

namespace lineatlas::test {

/// Where a picture is dark, over white.
struct Ink {
    glm::ivec2 size;
    std::vector<bool> dark;

    explicit Ink(const std::filesystem::path& path) {
        const Image image = read_image(path);
        size = image.size;
        const auto channels = static_cast<std::size_t>(image.channels);
        const bool has_alpha = channels == 2 || channels == 4;
        for (std::size_t i = 0; i < image.pixels.size(); i += channels) {
            const int alpha = has_alpha ? image.pixels[i + channels - 1] : 255;
            dark.push_back((image.pixels[i] * alpha + 255 * (255 - alpha)) / 255 < 128);
        }
    }

    bool near(int x, int y) const {
        for (int v = std::max(0, y - 1); v <= std::min(size.y - 1, y + 1); ++v) {
            for (int u = std::max(0, x - 1); u <= std::min(size.x - 1, x + 1); ++u) {
                if (dark[static_cast<std::size_t>(v * size.x + u)]) return true;
            }
        }
        return false;
    }

    /// The share of the dark pixels that lie within one pixel of a dark pixel of the other picture.
    double share_near(const Ink& other) const {
        std::size_t count = 0, found = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (!dark[static_cast<std::size_t>(y * size.x + x)]) continue;
                ++count;
                if (other.near(x, y)) ++found;
            }
        }
        return count == 0 ? 0 : static_cast<double>(found) / static_cast<double>(count);
    }
};

/// Expects that both pictures show the same lines: at least this share of the dark pixels of each
/// lies within one pixel of dark pixels of the other.
inline void expect_same_ink(const Ink& ours, const Ink& theirs, double least) {
    ASSERT_EQ(ours.size, theirs.size);
    EXPECT_GT(std::ranges::count(ours.dark, true), 1000);
    EXPECT_GE(ours.share_near(theirs), least);
    EXPECT_GE(theirs.share_near(ours), least);
}

inline bool is_installed(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

} // namespace lineatlas::test
