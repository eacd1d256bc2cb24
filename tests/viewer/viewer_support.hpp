#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <glm/gtc/constants.hpp>

#include "temporary_folder.hpp"
#include "viewer_driver.hpp"

namespace lineatlas::test {

inline std::string text_of(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream{path}.rdbuf();
    return text.str();
}

/// A cube of two units about `at`, as a separate object.
inline std::string box(const std::string& name, glm::vec3 at, int first) {
    std::ostringstream text;
    text.precision(9); // all digits of a float
    text << "o " << name << '\n';
    for (int i = 0; i < 8; ++i) {
        text << "v " << at.x + ((i & 1) != 0 ? 1 : -1) << ' ' << at.y + ((i & 2) != 0 ? 1 : -1)
             << ' ' << at.z + ((i & 4) != 0 ? 1 : -1) << '\n';
    }
    for (const auto& face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"}) {
        text << 'f';
        std::istringstream corners{face};
        for (int corner = 0; corners >> corner;) text << ' ' << first + corner - 1;
        text << '\n';
    }
    return text.str();
}

/// The numbers after each group code 10 and 11, or 20 and 21, of a DXF's lines.
struct Extent {
    double low = 1e9, high = -1e9;
    double length() const { return high - low; }
};
inline Extent extent_of(const std::string& dxf, int axis) {
    Extent extent;
    std::istringstream text{dxf.substr(dxf.find("ENTITIES\n") + 9)};
    std::string code, value;
    while (std::getline(text, code) && std::getline(text, value)) {
        const int number = std::atoi(code.c_str());
        if (number != 10 * (axis + 1) && number != 10 * (axis + 1) + 1) continue;
        extent.low = std::min(extent.low, std::stod(value));
        extent.high = std::max(extent.high, std::stod(value));
    }
    return extent;
}

/// A torus of 2 * `side` * `side` triangles.
inline std::string torus(int side) {
    std::ostringstream text;
    text << "o Torus\n";
    const auto angle = [&](int i) { return glm::two_pi<double>() * i / side; };
    for (int i = 0; i < side * side; ++i) {
        const double about = angle(i / side), around = angle(i % side);
        const double radius = 3 + std::cos(around);
        text << "v " << radius * std::cos(about) << ' ' << radius * std::sin(about) << ' '
             << std::sin(around) << '\n';
    }
    const auto corner = [&](int i, int k) { return 1 + (i % side) * side + k % side; };
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k)
            text << "f " << corner(i, k) << ' ' << corner(i + 1, k) << ' ' << corner(i + 1, k + 1)
                 << ' ' << corner(i, k + 1) << '\n';
    return text.str();
}

class Viewer : public testing::Test {
  protected:
    explicit Viewer(float scale = 1)
        : app_{{.size = {1280, 800}, .scale = scale, .scripted = true}, writer_} {
        app_.ui().folder = folder_.path().string();
        app_.ui().folded.clear();                 // methods and devices are in sight
        session().settings.exact_at_rest = false; // pictures are by the chosen method
        hand_.open_scene("clevis");
        EXPECT_TRUE(session().messages.all().empty());
    }

    viewer::Session& session() { return app_.session(); }
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
    std::vector<std::uint8_t> picture(std::size_t side = 0) {
        return session().picture(side)->read();
    }
    std::string error() {
        for (const auto& message : session().messages.all()) {
            if (message.error) return message.text;
        }
        return {};
    }
    /// Runs the tool with the viewer's saved files.
    void draw_by_tool(const std::string& arguments, const std::string& output) const {
        const std::string command = std::string{LINEATLAS_TOOL} + " draw --scene clevis " +
                                    arguments + " --camera-path " + path("clevis.json") + " -o " +
                                    path(output);
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
    }

    TemporaryFolder folder_;
    ImageWriter writer_;
    viewer::Application app_;
    ViewerDriver hand_{app_};
};

} // namespace lineatlas::test
