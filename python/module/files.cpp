#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "compute/opencl/devices.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"

namespace lineatlas::python {
namespace {

struct Device {
    std::string name, driver, kind;
};

std::vector<Device> devices() {
    const py::gil_scoped_release release;
    std::vector<Device> found;
    for (const compute::OpenClDevice& device : compute::list_opencl_devices()) {
        const char* kind = device.is_cpu ? "CPU" : device.is_gpu ? "GPU" : "accelerator";
        found.push_back({device.name(), device.driver_version, kind});
    }
    return found;
}

void save(const std::filesystem::path& path, const py::array& picture, float dpi,
          const std::string& description) {
    const bool fits = picture.ndim() == 3 && picture.shape(2) >= 1 && picture.shape(2) <= 4;
    if (!fits || !picture.dtype().is(py::dtype::of<std::uint8_t>()) || picture.size() == 0)
        throw UsageError("a picture to save is a (height, width, 1 to 4) array of uint8");
    const py::array_t<std::uint8_t, py::array::c_style> rows(picture);
    const auto bytes = static_cast<std::size_t>(rows.size());
    const Pixels pixels{.size = {static_cast<int>(rows.shape(1)), static_cast<int>(rows.shape(0))},
                        .channels = static_cast<int>(rows.shape(2)),
                        .values = std::as_bytes(std::span{rows.data(), bytes})};
    const ImageSettings settings{.dpi = dpi, .description = description};
    const py::gil_scoped_release release;
    write_image(path, pixels, settings);
}

} // namespace

void bind_files(py::module_& module) {
    py::class_<Device>(module, "Device", "An OpenCL device.")
        .def_readonly("name", &Device::name, "What Renderer takes as its device.")
        .def_readonly("driver", &Device::driver, "The driver's version.")
        .def_readonly("kind", &Device::kind, "CPU, GPU or accelerator.")
        .def("__repr__", [](const Device& device) {
            return "<lineatlas.Device " + device.name + " (" + device.kind + ")>";
        });
    module.def("devices", &devices,
               "The OpenCL devices of this machine. Without any, compute=\"reference\" works.");
    module.def("save", &save, py::arg("path"), py::arg("picture"), py::kw_only(),
               py::arg("dpi") = 0.0F, py::arg("description") = "",
               "Writes an array as draw() gives it as PNG, JPEG, TIFF, ..., by the extension of\n"
               "`path`, whole or not at all. Raises FileError.");
}

} // namespace lineatlas::python
