#pragma once

#include "lineatlas/headless.hpp"

namespace lineatlas::gl {

using lineatlas::HeadlessContext;

} // namespace lineatlas::gl
