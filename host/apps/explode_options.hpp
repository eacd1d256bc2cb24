#pragma once

#include <string>
#include <utility>
#include <vector>

#include <CLI/App.hpp>

#include "lineatlas/explode.hpp"

namespace lineatlas::apps {

/// --explode.
class ExplodeOptions {
  public:
    ExplodeOptions() = default;
    /// As a drawing's description has them.
    explicit ExplodeOptions(std::vector<std::string> values) : values_(std::move(values)) {}
    void declare(CLI::App& app, const std::string& group);

    bool given() const { return !values_.empty(); }
    /// Throws UsageError for what can't be, whatever the model.
    Explosion explosion() const;
    /// Throws UsageError for a part that there is not.
    void apply(LoadedMesh& loaded) const;

  private:
    std::vector<std::string> values_;
};

} // namespace lineatlas::apps
