#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <fmt/core.h>
#include <fmt/ranges.h> // fmt::join

#include "commands.hpp"
#include "io/atomic_file.hpp"
#include "io/extension.hpp"
#include "io/obj_writer.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/scenes.hpp"

namespace lineatlas::apps {
namespace {

struct SceneArguments {
    std::string name, output;
};

void write_scene(const SceneArguments& arguments) {
    if (lower_extension(arguments.output) != ".obj")
        throw UsageError("--output: a scene is written as OBJ; the name must end in .obj");
    const Scene scene = make_scene(arguments.name);
    const std::string text = to_obj(scene.mesh);
    AtomicFile{arguments.output}.commit(
        {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

} // namespace

Command setup_scene(CLI::App& app) {
    auto arguments = std::make_shared<SceneArguments>();
    app.add_option("NAME", arguments->name, fmt::format("{}", fmt::join(scene_names(), ", ")))
        ->required();
    app.add_option("-o,--output", arguments->output, "OBJ file to write")->required();
    app.footer("Example: lineatlas scene ship -o ship.obj");
    return [arguments] { write_scene(*arguments); };
}

} // namespace lineatlas::apps
