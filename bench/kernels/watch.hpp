#pragma once

#include <cstdint>
#include <string>

namespace lineatlas::bench {

/// What `--watch` measures again and again.
struct Watched {
    std::string name;      ///< of a stage or of one of its kernels
    std::uint32_t size;    ///< elements
    std::string device;    ///< as open_devices() takes it
    std::string form = {}; ///< the same
};

/// Measures a stage each time that a file in LINEATLAS_KERNEL_DIR is written: how long it takes, in
/// ratio to the last and the first measurement and to the kernels as C++, and whether its results
/// are theirs. What does not build is said in one line. Does not return. Throws UsageError for a
/// name that no row has, or without the variable.
[[noreturn]] void watch(const Watched& watched);

} // namespace lineatlas::bench
