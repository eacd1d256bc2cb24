#include "output_places.hpp"

#include <system_error>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "io/source_file.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

namespace fs = std::filesystem;

fs::path place_of(const fs::path& path) {
    const fs::path file = behind_links(path);
    std::error_code error;
    const fs::path place = fs::weakly_canonical(fs::absolute(file, error), error);
    return error ? file : place;
}

} // namespace

void OutputPlaces::reads(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return;
    known_.emplace(place_of(path), fmt::format("{}, which is read", quoted(path)));
}

void OutputPlaces::check(std::string_view option, const fs::path& path) const {
    const auto found = known_.find(place_of(path));
    if (found == known_.end()) return;
    throw UsageError(fmt::format("{} {} would overwrite {}; name another file", option,
                                 quoted(path), found->second));
}

void OutputPlaces::writes(std::string_view option, const fs::path& path) {
    check(option, path);
    known_.emplace(place_of(path), fmt::format("what {} writes", option));
}

} // namespace lineatlas::apps
