#pragma once

#include <string>
#include <vector>

#include "glpasses/interop/connect.hpp"

namespace lineatlas::bench {

/// What handing a buffer of one size over costs in one mode: medians in milliseconds.
struct HandoverCost {
    std::string device, mode;
    std::size_t bytes;
    double to_compute;  ///< all of it, written by GL just before
    double to_gl;       ///< all of it, written by a kernel just before
    double order_only;  ///< there and back with nothing to read, as for buffers to be filled
    double host_memcpy; ///< as many bytes within the host's memory
    bool right;         ///< whether the content arrived
};

/// A mode that is left out, and why.
struct NoHandover {
    std::string device, mode, reason;
};

struct HandoverReport {
    std::string gl;
    double call; ///< what a call does beyond its passes, in a program's context; milliseconds
    std::vector<HandoverCost> costs;
    std::vector<NoHandover> left_out;
};

struct HandoverOptions {
    std::string device;             ///< empty: every one
    std::vector<std::string> modes; ///< by name
    std::vector<std::size_t> sizes; ///< in bytes, multiples of 4
    unsigned rounds;
};

/// Needs a current GL context. Modes and devices take turns in every round.
HandoverReport measure_handovers(const HandoverOptions& options);

} // namespace lineatlas::bench
