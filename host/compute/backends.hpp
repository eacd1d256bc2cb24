#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "backend.hpp"

namespace lineatlas::compute {

/// A kind of compute backend that one can choose by its name.
struct BackendKind {
    std::string name;    ///< what `--compute` takes
    std::string summary; ///< a few words for lists
    /// `device`: what the user chose, in the backend's own terms; empty: its best. Throws
    /// UsageError for one that there is not, DeviceError when the backend can't work here.
    std::unique_ptr<Backend> (*make)(std::string_view device);
};

/// All that there are: the library's, then those that were registered.
const std::vector<BackendKind>& backend_kinds();

/// Makes another kind known to this process, from outside the library. Before any thread uses the
/// library; throws UsageError if the name is taken.
void register_backend(BackendKind kind);

/// "opencl, reference, ...", for messages.
std::string backend_names();

/// A backend of the kind `name`; throws UsageError, listing what there is, if there is none.
std::unique_ptr<Backend> make_backend(std::string_view name, std::string_view device = {});

} // namespace lineatlas::compute
