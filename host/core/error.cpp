#include "lineatlas/error.hpp"

#include "base/printable.hpp"

namespace lineatlas {

Error::Error(const std::string& message)
    : std::runtime_error(printable(message, longest_message)) {}

Error::Error(const std::string& message, const std::string& log)
    : std::runtime_error(printable(message, longest_message) +
                         (log.empty() ? "" : ":\n" + printable_lines(log))) {}

} // namespace lineatlas
