#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arguments.hpp"
#include "arrays.hpp"
#include "bindings.hpp"
#include "compute/opencl/devices.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "process.hpp"

namespace lineatlas::python {
namespace {

struct Device {
    std::string name, driver, kind;
};

std::vector<Device> devices() {
    const Released released;
    enter_drivers();
    std::vector<Device> found;
    for (const compute::OpenClDevice& device : compute::list_opencl_devices()) {
        const char* kind = device.is_cpu ? "CPU" : device.is_gpu ? "GPU" : "accelerator";
        found.push_back({device.name(), device.driver_version, kind});
    }
    return found;
}

void save(const Argument<std::filesystem::path, "path", "a path">& path, const py::object& given,
          Real<"dpi"> dpi, const Word<"description">& description) {
    const py::array picture = py::isinstance<py::array>(given) ? py::array(given) : py::array();
    const bool fits = picture.ndim() == 3 && picture.shape(2) >= 1 && picture.shape(2) <= 4;
    if (!fits || !picture.dtype().is(py::dtype::of<std::uint8_t>()) || picture.size() == 0)
        throw UsageError("a picture to save is a (height, width, 1 to 4) array of uint8");
    const py::array_t<std::uint8_t, py::array::c_style> rows(picture);
    const auto bytes = static_cast<std::size_t>(rows.size());
    const Pixels pixels{.size = {static_cast<int>(rows.shape(1)), static_cast<int>(rows.shape(0))},
                        .channels = static_cast<int>(rows.shape(2)),
                        .values = std::as_bytes(std::span{rows.data(), bytes})};
    const ImageSettings settings{.dpi = dpi, .description = *description};
    const Released released;
    write_image(*path, pixels, settings);
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
               "The OpenCL devices of this machine. Without any, kernels run as C++.");
    module.def("save", &save, py::arg("path"), py::arg("picture"), py::kw_only(),
               py::arg("dpi") = 0.0F, py::arg("description") = "",
               "Writes an array as draw() gives it as PNG, JPEG, TIFF, ..., by the extension of\n"
               "`path`, whole or not at all. Raises FileError.");
}

} // namespace lineatlas::python
