#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "compute/opencl/devices.hpp"
#include "glpasses/headless_context.hpp"
#include "glpasses/interop/connect.hpp"
#include "support/gl_sharing_layer/layer.hpp"

namespace lineatlas::test {

/// Makes the OpenCL loader load the layer. Call it before the first OpenCL call of the process.
inline void use_gl_sharing_layer() {
    ::setenv("OPENCL_LAYERS", LINEATLAS_GL_SHARING_LAYER, 1);
}

inline LayerCounts take_counts() {
    void* layer = dlopen(LINEATLAS_GL_SHARING_LAYER, RTLD_LAZY | RTLD_NOLOAD);
    if (layer == nullptr) throw std::runtime_error{"the OpenCL loader has not taken the layer"};
    const auto take = reinterpret_cast<TakeLayerCounts*>(dlsym(layer, take_layer_counts_symbol));
    dlclose(layer);
    return take();
}

/// Sets the behaviour of the driver from now on; see gl_sharing_layer/layer.cpp.
inline void behave(const char* behaviour) {
    ::setenv("LINEATLAS_TEST_LAYER", behaviour, 1);
}

/// The layer behaves as a driver should until told otherwise.
class UsesLayer : public testing::Test {
  protected:
    UsesLayer() {
        use_gl_sharing_layer();
        behave("");
        device(); // the loader loads the layer in the first call
    }
    ~UsesLayer() override { behave(""); }

    static compute::OpenClDevice device() { return compute::list_opencl_devices().at(0); }
};

/// Tests with a GL context that EGL has made.
class GlSharing : public UsesLayer {
  protected:
    /// The reason why no Vulkan device exports memory to GL; empty if one does.
    static std::string missing_vulkan() {
        behave("external");
        const std::string reason =
            interop::probe_mode(device(), interop::SharingMode::external_memory).reason;
        return reason.find("ulkan") != std::string::npos &&
                       reason.find("round trip succeeded") == std::string::npos
                   ? reason
                   : std::string{};
    }

  private:
    gl::HeadlessContext context_;
};

} // namespace lineatlas::test
