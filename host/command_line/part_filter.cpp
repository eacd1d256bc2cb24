#include "part_filter.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "base/name_pattern.hpp"
#include "base/printable.hpp"
#include "io/part_paths.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

/// The names of parts, as many as fit into a line.
std::string listed(const std::vector<PartPath>& paths) {
    constexpr std::size_t most = 12;
    std::set<std::string> names;
    for (const PartPath& path : paths)
        if (!path.names.empty() && !path.names.back().empty())
            names.insert(printable(path.names.back()));
    if (names.empty()) return "its parts have no names";
    const std::size_t more = names.size() > most ? names.size() - most : 0;
    while (names.size() > most) names.erase(std::prev(names.end()));
    return fmt::format("there is \"{}\"{}", fmt::join(names, "\", \""),
                       more > 0 ? fmt::format(" and {} more", more) : "");
}

} // namespace

void PartFilter::declare(CLI::App& app, const std::string& group) {
    app.add_option("--only", only_,
                   "Draw only parts of this name (and the parts inside them); * and ? stand for "
                   "any letters; may be given several times")
        ->allow_extra_args(false)
        ->group(group);
    app.add_option("--hide", hidden_, "Leave out parts of this name, likewise")
        ->allow_extra_args(false)
        ->group(group);
}

void PartFilter::apply(LoadedMesh& loaded) const {
    if (!given()) return;
    const PartPaths paths = part_paths(loaded);
    const auto wanted_part = [&](const PartPath& path) {
        const std::string whole = path.whole();
        const auto named = [&](const std::string& pattern) { return names_part(pattern, whole); };
        return (only_.empty() || std::ranges::any_of(only_, named)) &&
               std::ranges::none_of(hidden_, named);
    };
    for (const auto* patterns : {&only_, &hidden_}) {
        for (const std::string& pattern : *patterns) {
            if (std::ranges::any_of(paths.paths, [&](const PartPath& path) {
                    return names_part(pattern, path.whole());
                }))
                continue;
            throw UsageError(fmt::format("{}: no part is called \"{}\"; {}",
                                         patterns == &only_ ? "--only" : "--hide", pattern,
                                         listed(paths.paths)));
        }
    }
    std::vector<bool> wanted;
    for (const PartPath& path : paths.paths) wanted.push_back(wanted_part(path));
    keep_parts(loaded.mesh, paths, wanted, only_.empty());
    if (loaded.mesh.empty())
        throw UsageError(
            "--only and --hide leave nothing to draw; `lineatlas info` lists the parts");
}

} // namespace lineatlas
