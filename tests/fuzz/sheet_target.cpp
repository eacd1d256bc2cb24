#include <cmath>

#include "core/drawing_scale.hpp"
#include "fuzz.hpp"
#include "lineatlas/sheet.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lineatlas;
    const std::filesystem::path file = fuzz::put_file(".toml", {data, size});
    try {
        const SheetOptions sheet = load_sheet(file);
        fuzz::expect(!sheet.views.empty(), "a sheet without views");
        const auto check_scale = [](const std::string& scale) {
            fuzz::expect(scale.empty() || parse_scale("the scale", scale) > 0,
                         "a scale that is none");
        };
        check_scale(sheet.scale);
        for (const SheetPlacement& placed : sheet.placements) check_scale(placed.scale);
        for (const SheetDetail& detail : sheet.details) {
            check_scale(detail.scale);
            fuzz::expect(detail.radius > 0 && std::isfinite(detail.radius),
                         "a detail without a radius");
        }
    } catch (const FileError& error) {
        fuzz::expect_good_refusal(error, file);
    }
    return 0;
}
