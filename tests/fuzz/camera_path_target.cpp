#include <cmath>

#include "cameras/camera_file.hpp"
#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lineatlas;
    const std::filesystem::path file = fuzz::put_file(".json", {data, size});
    try {
        const CameraPath path = read_camera_path(file, View{});
        fuzz::expect(path.first_frame() <= path.last_frame(), "a path that ends before it begins");
        for (const int frame : {path.first_frame(), path.last_frame()}) {
            const View view = path.view(frame);
            for (const glm::vec3 vector : {view.eye, view.target, view.up}) {
                fuzz::expect(std::isfinite(vector.x + vector.y + vector.z),
                             "a view that is not finite");
            }
        }
    } catch (const FileError& error) {
        fuzz::expect_good_refusal(error, file);
    }
    return 0;
}
