#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include "command_line/read_options.hpp"
#include "commands.hpp"
#include "io/isolated.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/io.hpp"
#include "model_info.hpp"

namespace lineatlas::apps {
namespace {

struct InfoArguments {
    std::string model;
    bool json = false;
    ReadOptions read;
};

void print_info(const InfoArguments& arguments) {
    arguments.read.check();
    const LoadedMesh loaded = load_mesh_isolated(arguments.model, arguments.read.limits());
    const nlohmann::ordered_json info =
        describe_model(arguments.model, loaded, extract_lines(loaded.mesh));
    // Names come from the file and need not be UTF-8.
    constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
    print_output(arguments.json ? info.dump(2, ' ', false, replace) + '\n' : to_text(info));
}

} // namespace

Command setup_info(CLI::App& app) {
    auto arguments = std::make_shared<InfoArguments>();
    app.add_option("MODEL", arguments->model, "File of a model")->required();
    app.add_flag("--json", arguments->json, "As JSON, for scripts");
    arguments->read.declare(app);
    app.footer("Example: lineatlas info assembly.step --json");
    return [arguments] { print_info(*arguments); };
}

} // namespace lineatlas::apps
