#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "lineatlas/renderer.hpp"

namespace lineatlas::bench {

/// A method of Table 1 at one of its two qualities, or the method `exact`, which has one quality.
struct MethodSpec {
    std::string_view name;
    Method method;
    std::uint32_t probes;
    int depth_scale;
    bool silhouettes; ///< finds silhouettes itself; methods that do not are left out of the "+s"
                      ///< rows
    bool reads_back = false; ///< reads back the visible intervals of every frame (§4.6)
};

/// OGL, IBlo, IBhi, STlo, SThi, SAlo, SAhi, SAhi+read (SAhi with readback) and EX (exact).
std::span<const MethodSpec> method_specs();

/// Throws UsageError for an unknown name.
const MethodSpec& method_spec(std::string_view name);

} // namespace lineatlas::bench
