#include "lineatlas/compute_device.hpp"
#include "sources/sources.hpp"

namespace lineatlas::compute {

std::string source_of(const Kernel& kernel) {
    return line_directive(1, kernel.file()) + kernel_source(kernel.file());
}

} // namespace lineatlas::compute
