#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "compute/backend.hpp"

namespace lineatlas::compute {

/// A backend that does every stage twice, on `first` and with the same input on a second backend,
/// and compares what they write: integers bit by bit, floats within 1e-5 relative. Its results are
/// those of `first`. The first stage that differs throws MismatchError with the first element that
/// does. For finding errors: every table is copied at every stage.
class ComparingBackend : public Backend {
  public:
    struct Summary {
        std::uint64_t stages = 0;   ///< calls that were compared
        std::uint64_t elements = 0; ///< of the tables they write
    };
    virtual Summary summary() const = 0;
};

/// Compares the stages from the first up to `until` in the order of a frame; empty: all. Throws
/// UsageError if there is no such stage.
std::unique_ptr<ComparingBackend> make_comparing_backend(std::unique_ptr<Backend> first,
                                                         std::unique_ptr<Backend> second,
                                                         std::string_view until = {});

} // namespace lineatlas::compute
