#pragma once

#include <cstdint>
#include <string>

namespace lineatlas::bench {

/// The row that `--watch` measures again and again.
struct Watched {
    std::string name;      ///< name of a stage or of one of its kernels
    std::uint32_t size;    ///< number of elements
    std::string device;    ///< as open_devices() takes it
    std::string form = {}; ///< likewise
};

/// Measures a stage each time that a file in LINEATLAS_KERNEL_DIR is written. Prints its time, the
/// ratios to the last and the first measurement and to `cpp`, and whether its results equal those
/// of `cpp`. A kernel that does not build gives one line. Never returns. Throws UsageError for a
/// name that no row has, or without the variable.
[[noreturn]] void watch(const Watched& watched);

} // namespace lineatlas::bench
