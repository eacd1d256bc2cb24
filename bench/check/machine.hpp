#pragma once

#include <nlohmann/json.hpp>

namespace lineatlas::bench {

/// Processor, memory, system and driver of this machine, as far as they can be read.
nlohmann::ordered_json describe_machine();

} // namespace lineatlas::bench
