#pragma once

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "temporary_folder.hpp"
#include "viewer_driver.hpp"

namespace lineatlas::test {

inline std::string text_of(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream{path}.rdbuf();
    return text.str();
}

class Viewer : public testing::Test {
  protected:
    explicit Viewer(float scale = 1)
        : app_{{.size = {1280, 800}, .scale = scale, .scripted = true}, writer_} {
        app_.ui().folder = folder_.path().string();
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
    /// Runs the tool with what the viewer has saved.
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
