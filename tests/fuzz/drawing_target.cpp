// Reads a drawing as `lineatlas check` does. LINEATLAS_FUZZ_EXTENSION is ".svg" or ".json".
#include <cmath>

#include "fuzz.hpp"
#include "truth/drawing_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lineatlas;
    const std::filesystem::path file = fuzz::put_file(LINEATLAS_FUZZ_EXTENSION, {data, size});
    try {
        const DrawingFile drawing = read_drawing(file);
        fuzz::expect(drawing.size.x > 0 && drawing.size.y > 0, "a picture without pixels");
        constexpr double farthest = 1e6;
        const auto is_near = [](glm::dvec2 at) {
            return std::abs(at.x) <= farthest && std::abs(at.y) <= farthest;
        };
        for (const DrawnPiece& leg : drawing.legs)
            fuzz::expect(is_near(leg.from) && is_near(leg.to), "a line that no picture shows");
        for (const TaggedPiece& tag : drawing.tags)
            fuzz::expect(is_near(tag.from) && is_near(tag.to), "a tag that no picture shows");
    } catch (const FileError& error) {
        fuzz::expect_good_refusal(error, file);
    }
    return 0;
}
