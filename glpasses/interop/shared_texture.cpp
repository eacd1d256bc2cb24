#include "shared_texture.hpp"

#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas::interop {

SharedTexture::SharedTexture(const compute::OpenClBackend& device, GLuint texture) {
    try {
        image_ =
            cl::ImageGL{device.context(), CL_MEM_READ_WRITE, GL_TEXTURE_2D, 0, texture, nullptr};
    } catch (const cl::Error& error) {
        throw DeviceError(std::string{"sharing a GL texture failed: "} + error.what() +
                          " returned " + std::to_string(error.err()));
    }
}

} // namespace lineatlas::interop
