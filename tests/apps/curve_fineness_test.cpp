// Exact surfaces drawn by the tool. With any size of picture and any camera, chords are off by at
// most a quarter of a pixel.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <nlohmann/json.hpp>

#include "tool.hpp"

namespace lineatlas::test {
namespace {

class CurveFineness : public Tool {
  protected:
    nlohmann::json drawn(const std::string& options) const {
        const std::string pin =
            std::string{LINEATLAS_SOURCE_DIR} + "/tests/fuzz/inputs/step/pin.step";
        const Result result = run("draw " + pin + " -o " + path("a.json") +
                                  " --lines crease --projection orthographic " + options);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        said_ = result.output;
        return nlohmann::json::parse(std::ifstream{path("a.json")});
    }

    /// The largest error of chords of the pin's upper end, a circle of radius 1, in model units.
    static double most_off(const nlohmann::json& drawing) {
        double most = 0;
        for (const nlohmann::json& line : drawing.at("paths")) {
            const nlohmann::json& world = line.at("world");
            for (std::size_t i = 0; i + 1 < world.size(); ++i) {
                const auto at = [&](std::size_t k) {
                    return glm::dvec2{world[k][0].get<double>(), world[k][1].get<double>()};
                };
                most = std::max(most, 1 - glm::length(0.5 * (at(i) + at(i + 1))));
            }
        }
        return most;
    }

    mutable std::string said_;
};

TEST_F(CurveFineness, ChordsAreOffByAQuarterPixelAtAnyPictureSize) {
    for (const int size : {200, 1000, 5000}) {
        const nlohmann::json drawing =
            drawn("--view top --size " + std::to_string(size) + "x" + std::to_string(size));
        // The circle of radius 1 fills the picture except its margin.
        EXPECT_LE(most_off(drawing) * size / 2, 0.25) << size;
        EXPECT_EQ(said_.find("pixels off"), std::string::npos) << said_;
    }
}

TEST_F(CurveFineness, ChordsAreOffByAQuarterPixelInCloseViews) {
    // Parallel, 40 degrees: it shows a height of 2 tan 20 times the distance.
    constexpr double distance = 0.2, shown = 2 * 0.36397 * distance;
    const std::string near = "--size 1000x1000 --target 1,0,2 --up y --eye 1,0,2.2 ";
    const double scale = 1000 / shown;
    const nlohmann::json drawing = drawn(near);
    const double off = most_off(drawing);
    EXPECT_GT(off, 0);
    EXPECT_LE(off * scale, 0.25);
    // The drawing holds the deflection of the reading, so that it can be checked.
    const std::string description = drawing.at("description").get<std::string>();
    EXPECT_NE(description.find(" --deflection="), std::string::npos) << description;
    // A given deflection is used. The circle stays a circle.
    const nlohmann::json coarse = drawn(near + "--deflection 0.01");
    const std::string given = coarse.at("description").get<std::string>();
    EXPECT_NE(given.find(" --deflection=0.01"), std::string::npos) << given;
    EXPECT_LE(most_off(coarse) * scale, 0.25);
}

TEST_F(CurveFineness, UsualViewsAreReadOnce) {
    const std::string pin = std::string{LINEATLAS_SOURCE_DIR} + "/tests/fuzz/inputs/step/pin.step";
    ASSERT_EQ(run("draw " + pin + " -o " + path("a.svg")).exit_code, 0);
    // A second reading would have used the camera's deflection. This camera is nearer to parts of
    // the pin than one that frames the whole pin.
    const std::string svg = read(path("a.svg")), option = "--deflection=";
    const std::size_t at = svg.find(option);
    ASSERT_NE(at, svg.npos);
    const double deflection = std::atof(svg.c_str() + at + option.size());
    EXPECT_NEAR(0.25 / deflection, 1.1 * 2.25 * 768 / std::sqrt(12.0), 0.1);
}

TEST_F(CurveFineness, AViewALittleLargerThanGuessedIsReadOnce) {
    // The guess lets the pin's diagonal fill the picture from corner to corner.
    constexpr double guessed = 500 * std::numbers::sqrt2 / 3.4641016;
    const auto read_for = [&](double scale) {
        const double distance =
            500 / (2 * 0.36397 * scale); // see ChordsAreOffByAQuarterPixelInCloseViews
        const std::string description =
            drawn("--size 500x500 --target 0,0,0 --up y --eye 0,0," + std::to_string(distance))
                .at("description");
        const std::string option = "--deflection=";
        const std::size_t at = description.find(option);
        return at == description.npos ? 0
                                      : 0.25 / std::atof(description.c_str() + at + option.size());
    };
    EXPECT_NEAR(read_for(1.05 * guessed), 1.1 * guessed, 0.1);
    EXPECT_NEAR(read_for(1.3 * guessed), 1.3 * guessed, 1);
}

TEST_F(CurveFineness, ANoteTellsWhereTheLimitOfFinenessIsReached) {
    drawn("--size 4000x4000 --target 1,0,2 --up y --eye 1,0,2.001 ");
    EXPECT_NE(said_.find("pixels off in this picture; --deflection"), std::string::npos) << said_;
}

} // namespace
} // namespace lineatlas::test
