#pragma once

#include <epoxy/gl.h>

#include "compute/opencl/opencl_backend.hpp"
#include "shared.hpp"

namespace lineatlas::interop {

/// A two-dimensional GL texture that OpenCL has opened as an image. Only gl-sharing can do that.
/// The renderer passes depth as a buffer, which every mode can; see docs/interop.md.
class SharedTexture final : public Shared {
  public:
    /// Opens level 0 of `texture`. Its size and format must be final, and it must outlive this
    /// object. Throws DeviceError if the driver refuses, as it does for formats that OpenCL lacks.
    SharedTexture(const compute::OpenClBackend& device, GLuint texture);

    const cl::Image& image() const { return image_; } ///< for kernels, while compute has it

  private:
    _cl_mem* opened() const override { return image_(); }

    cl::ImageGL image_;
};

} // namespace lineatlas::interop
