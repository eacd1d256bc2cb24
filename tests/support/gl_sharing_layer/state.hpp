#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CL/cl_gl.h>
#include <CL/cl_icd.h>
#include <epoxy/gl.h>

#include "layer.hpp"

namespace lineatlas::test {

/// A GL buffer or texture that was opened, or memory that was imported, and its copy in OpenCL.
struct Opened {
    GLuint gl;
    std::size_t bytes;
    std::size_t width, height; ///< of a texture; 0 for a buffer
    GLenum format, type;       ///< of a texture's transfers
    bool acquired;
    bool in_flight; ///< released, but GL would not see it yet
    std::vector<std::byte> content;
    unsigned references = 1;               ///< the program's
    std::shared_ptr<std::byte> imported{}; ///< the imported memory; null for GL's objects
};

struct State {
    const cl_icd_dispatch* driver;
    LayerCounts counts{};
    std::map<cl_mem, Opened> opened;
    std::map<cl_kernel, std::map<cl_uint, cl_mem>> arguments; ///< only opened objects
    std::map<cl_event, bool> fences;                          ///< made of GL fences
};
State& state();

/// True if LINEATLAS_TEST_LAYER names this behaviour.
bool behaves(std::string_view name);

void violation(const std::string& message);
/// Counts a violation if `object` is opened but not acquired.
void check_use(cl_mem object, const char* by);

} // namespace lineatlas::test
