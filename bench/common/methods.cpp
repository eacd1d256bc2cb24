#include "methods.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/core.h>

#include "lineatlas/error.hpp"
#include "style/frame_settings.hpp"

namespace lineatlas::bench {
namespace {

constexpr Sampling low = sampling_of(Quality::low), high = sampling_of(Quality::high);

constexpr std::array<MethodSpec, 9> specs{{
    {"OGL", Method::opengl, low.probes, low.depth_scale, false},
    {"IBlo", Method::item_buffer, low.probes, low.depth_scale, false},
    // The item buffer itself is supersampled, by its number of probes.
    {"IBhi", Method::item_buffer, high.probes, 1, false},
    {"STlo", Method::spine, low.probes, low.depth_scale, true},
    {"SThi", Method::spine, high.probes, high.depth_scale, true},
    {"SAlo", Method::atlas, low.probes, low.depth_scale, true},
    {"SAhi", Method::atlas, high.probes, high.depth_scale, true},
    {"SAhi+read", Method::atlas, high.probes, high.depth_scale, true, true},
    // EX has no samples. Its result is exact at any quality.
    {"EX", Method::exact, high.probes, high.depth_scale, true},
}};

} // namespace

std::span<const MethodSpec> method_specs() {
    return specs;
}

const MethodSpec& method_spec(std::string_view name) {
    const auto found = std::ranges::find(specs, name, &MethodSpec::name);
    if (found != specs.end()) return *found;
    std::string names;
    for (const MethodSpec& spec : specs) {
        names += names.empty() ? "" : ", ";
        names += spec.name;
    }
    throw UsageError(fmt::format("--methods: there is no \"{}\"; there is {}", name, names));
}

} // namespace lineatlas::bench
