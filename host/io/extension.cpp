#include "extension.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace lineatlas {

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

UsualUp usual_up(const std::filesystem::path& model) {
    // Machines are drawn lying on a table.
    constexpr std::array lying{".stl", ".step", ".stp", ".iges", ".igs", ".brep", ".brp"};
    const bool lies = std::ranges::find(lying, lower_extension(model)) != lying.end();
    return lies ? UsualUp::z : UsualUp::y;
}

} // namespace lineatlas
