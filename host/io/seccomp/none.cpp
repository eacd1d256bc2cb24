// For a build without libseccomp.
#include "io/system_calls.hpp"

namespace lineatlas {

bool knows_seccomp() {
    return false;
}

bool has_seccomp() {
    return false;
}

void restrict_system_calls() {}

} // namespace lineatlas
