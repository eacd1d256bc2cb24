#pragma once

namespace lineatlas::example {

/// Makes the backend "threads" known: `compute::make_backend("threads")`, DeviceOptions::compute.
void register_threads_backend();

} // namespace lineatlas::example
