#include "named_files.hpp"

#include <algorithm>
#include <system_error>

#include "source_file.hpp"

namespace lineatlas {

namespace {

namespace fs = std::filesystem;

bool is_below(const fs::path& path, const fs::path& folder) {
    return std::ranges::mismatch(folder, path).in1 == folder.end();
}

} // namespace

NamedFiles::NamedFiles(const fs::path& model) {
    std::error_code error;
    folder_ = fs::absolute(model, error).lexically_normal().parent_path();
    real_folder_ = fs::canonical(folder_, error);
}

NamedFiles::Outcome NamedFiles::read(const fs::path& name, std::string& contents) const {
    // The name is checked first, so that nothing outside the folder is even asked for.
    const fs::path path = (folder_ / name).lexically_normal();
    if (!is_below(path, folder_)) return Outcome::outside;
    std::error_code error;
    const fs::path real = fs::canonical(path, error);
    if (error) return Outcome::missing;
    if (!is_below(real, real_folder_)) return Outcome::outside;
    if (!fs::is_regular_file(real, error)) return Outcome::missing;
    try {
        contents = fs::is_empty(real) ? "" : read_source(real).bytes;
    } catch (const FileError&) {
        return Outcome::missing;
    } catch (const fs::filesystem_error&) {
        return Outcome::missing;
    }
    return Outcome::read;
}

} // namespace lineatlas
