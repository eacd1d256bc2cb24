#pragma once

#include <string>
#include <utility>
#include <vector>

#include "command_line/cli_fwd.hpp"
#include "lineatlas/explode.hpp"

namespace lineatlas::apps {

/// --explode.
class ExplodeOptions {
  public:
    ExplodeOptions() = default;
    /// The values in a drawing's description.
    explicit ExplodeOptions(std::vector<std::string> values) : values_(std::move(values)) {}
    void declare(CLI::App& app, const std::string& group);

    bool given() const { return !values_.empty(); }
    /// The explosion. Throws UsageError for values that are wrong for any model.
    Explosion explosion() const;
    /// Explodes the model. Throws UsageError for a part that it does not have.
    void apply(LoadedMesh& loaded) const;

  private:
    std::vector<std::string> values_;
};

} // namespace lineatlas::apps
