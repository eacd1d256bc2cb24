#pragma once

#include <stdexcept>
#include <string>

namespace lineatlas::threemf {

[[noreturn]] inline void refuse(const std::string& cause) {
    throw std::runtime_error(cause);
}

} // namespace lineatlas::threemf
