#include "methods.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/core.h>

#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::array<MethodSpec, 8> specs{{
    {"OGL", Method::opengl, 1, 1, false},
    {"IBlo", Method::item_buffer, 1, 1, false},
    {"IBhi", Method::item_buffer, 9, 1, false}, // supersampled itself; 9 probes say how much
    {"STlo", Method::spine, 1, 1, true},
    {"SThi", Method::spine, 9, 2, true},
    {"SAlo", Method::atlas, 1, 1, true},
    {"SAhi", Method::atlas, 9, 2, true},
    {"SAhi+read", Method::atlas, 9, 2, true, true},
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
