#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli_fwd.hpp"
#include "lineatlas/io.hpp"

namespace lineatlas {

/// --only and --hide: which parts of a model are drawn, by their names.
class PartFilter {
  public:
    PartFilter() = default;
    PartFilter(std::vector<std::string> only, std::vector<std::string> hidden)
        : only_(std::move(only)), hidden_(std::move(hidden)) {}
    void declare(CLI::App& app, const std::string& group);

    bool given() const { return !only_.empty() || !hidden_.empty(); }

    /// Removes unwanted parts from the mesh. Throws UsageError that names the existing parts if a
    /// pattern matches none, or if nothing is left.
    void apply(LoadedMesh& loaded) const;

  private:
    std::vector<std::string> only_, hidden_;
};

} // namespace lineatlas
