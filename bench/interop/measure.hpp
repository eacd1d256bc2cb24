#pragma once

#include <string>
#include <vector>

#include "glpasses/interop/connect.hpp"

namespace lineatlas::bench {

/// The cost of handing over a buffer of one size in one sharing mode: medians in milliseconds.
struct HandoverCost {
    std::string device, mode;
    std::size_t bytes;
    double to_compute;  ///< of a whole buffer that GL has just written
    double to_gl;       ///< of a whole buffer that a kernel has just written
    double order_only;  ///< there and back without content, as for buffers to be filled
    double host_memcpy; ///< memcpy of as many bytes on the host
    bool right;         ///< the content arrived
};

/// A sharing mode that is left out, and the reason.
struct NoHandover {
    std::string device, mode, reason;
};

struct HandoverReport {
    std::string gl;
    double call; ///< milliseconds of a call beyond its passes, in a program's context
    std::vector<HandoverCost> costs;
    std::vector<NoHandover> left_out;
};

struct HandoverOptions {
    std::string device;             ///< empty: all devices
    std::vector<std::string> modes; ///< names of sharing modes
    std::vector<std::size_t> sizes; ///< in bytes, multiples of 4
    unsigned rounds;
};

/// Measures all hand-overs. Needs a current GL context. Modes and devices take turns in every
/// round.
HandoverReport measure_handovers(const HandoverOptions& options);

} // namespace lineatlas::bench
