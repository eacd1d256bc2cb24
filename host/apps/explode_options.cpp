#include "explode_options.hpp"

#include <CLI/App.hpp>
#include <fmt/format.h>

#include "base/numbers.hpp"
#include "command_line/values.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {

void ExplodeOptions::declare(CLI::App& app, const std::string& group) {
    app.add_option(
           "--explode", values_,
           "Draw parts apart, with trails from where they belong. A factor, as 1.5: so many "
           "times as far from the middle of their assembly. PART=X,Y,Z: parts of that name "
           "are moved, in the model's unit. May be given several times")
        ->type_name("FACTOR|PART=X,Y,Z")
        ->allow_extra_args(false)
        ->group(group);
}

Explosion ExplodeOptions::explosion() const {
    Explosion result;
    for (const std::string& value : values_) {
        const std::size_t sign = value.rfind('=');
        if (const auto factor = number_from<double>(value)) {
            result.factor = *factor;
        } else if (sign != std::string::npos && sign > 0) {
            result.moves.push_back({.part = value.substr(0, sign),
                                    .by = parse_point("--explode", value.substr(sign + 1))});
        } else {
            throw UsageError(fmt::format(
                "--explode \"{}\" is neither a factor, as 1.5, nor a move, as \"Bolt*=0,0,20\"",
                value));
        }
    }
    return result;
}

void ExplodeOptions::apply(LoadedMesh& loaded) const {
    if (given()) explode(loaded, explosion());
}

} // namespace lineatlas::apps
