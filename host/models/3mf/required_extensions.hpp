#pragma once

#include <string_view>

namespace lineatlas::threemf {

/// Refuses, by name, the first extension that the first tag of a model requires and that is not
/// read. lib3mf only warns of such an extension, without its name. `head` is the beginning of the
/// model's XML.
void check_required_extensions(std::string_view head);

} // namespace lineatlas::threemf
