#include "scan.hpp"

#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "io/atomic_file.hpp"

namespace lineatlas::bench {
namespace {

constexpr int rows = 200, columns = 200; // of quads, around the ring and around its tube

/// A hash of `i`, from 0 to 1.
double noise(std::uint32_t i) {
    i = (i ^ (i >> 16U)) * 0x45D9F3BU;
    i = (i ^ (i >> 16U)) * 0x45D9F3BU;
    return static_cast<double>(i ^ (i >> 16U)) * 0x1p-32;
}

} // namespace

void write_scan(const std::filesystem::path& path) {
    constexpr double ring = 1, tube = 0.45, lobes = 0.2, roughness = 0.002;
    std::string text;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double u = 2 * std::numbers::pi * row / rows;
            const double v = 2 * std::numbers::pi * column / columns;
            const auto own = static_cast<std::uint32_t>(row * columns + column);
            const double thick =
                tube * (1 + lobes * std::sin(3 * u + v)) + roughness * (noise(own) - 0.5);
            const double out = ring + thick * std::cos(v);
            fmt::format_to(std::back_inserter(text), "v {:.6f} {:.6f} {:.6f}\n", out * std::cos(u),
                           out * std::sin(u), thick * std::sin(v));
        }
    }
    const auto at = [](int row, int column) { return row % rows * columns + column % columns + 1; };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int a = at(row, column), b = at(row + 1, column);
            const int c = at(row + 1, column + 1), d = at(row, column + 1);
            fmt::format_to(std::back_inserter(text), "f {} {} {}\nf {} {} {}\n", a, b, c, a, c, d);
        }
    }
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

} // namespace lineatlas::bench
