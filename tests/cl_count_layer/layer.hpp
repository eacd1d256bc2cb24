#pragma once

#include <array>

/// A layer between the OpenCL loader and the drivers (OPENCL_LAYERS) that counts references: what
/// was created or retained and not released yet.
namespace lineatlas::test {

enum ClKind { cl_contexts, cl_queues, cl_memory, cl_programs, cl_kernels, cl_events, cl_kinds };

using ClCounts = std::array<long, cl_kinds>;

/// The layer exports this.
using CountClReferences = ClCounts();
inline constexpr const char* count_cl_references_symbol = "lineatlas_test_count_cl_references";

} // namespace lineatlas::test
