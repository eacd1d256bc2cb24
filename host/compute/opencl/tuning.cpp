#include "tuning.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/sources.hpp"
#include "quirks.hpp"
#include "tuning_table.hpp"

namespace lineatlas::compute {
namespace {

constexpr std::string_view file_name = "tuning.toml";

/// A folder of kernels need not have a table: then the built-in one holds.
TuningTable user_table() {
    const char* folder = std::getenv("LINEATLAS_KERNEL_DIR");
    if (folder != nullptr) {
        const std::filesystem::path path = std::filesystem::path{folder} / file_name;
        std::error_code ignored;
        if (std::filesystem::exists(path, ignored)) {
            return TuningTable{kernel_source(file_name), path.string()};
        }
    }
    const auto& sources = embedded_kernels();
    const auto own = std::ranges::find(sources, file_name, &EmbeddedSource::name);
    return TuningTable{own->text, "the built-in " + std::string{file_name}};
}

} // namespace

Tuning tuning_for(const OpenClDevice& device) {
    return within_quirks(user_table().values_for(device), device);
}

} // namespace lineatlas::compute
