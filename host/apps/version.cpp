#include "version.hpp"

#include <string_view>

#include <fmt/format.h>

#include "command_line/sibling_program.hpp"
#include "io/module_files.hpp"

namespace lineatlas::apps {
namespace {

std::string state_of(const ModuleFile& module) {
    if (has_module(module)) return "here";
    if (!was_built(module)) return fmt::format("left out: built without {}", module.library);
    if (module.own_package == nullptr) return "not installed";
    return fmt::format("not installed: package {}", module.own_package);
}

} // namespace

std::string version() {
    std::string text = "lineatlas " LINEATLAS_VERSION;
    const auto add = [&](std::string_view name, std::string_view state) {
        text += fmt::format("\n  {:<24}{}", name, state);
    };
    for (const ModuleFile* module : module_files::all) add(module->name, state_of(*module));
    for (const char* program :
         {"lineatlas-view", "lineatlas-bench-frames", "lineatlas-bench-quality"})
        add(program, has_sibling(program) ? "here" : "not here");
    return text;
}

} // namespace lineatlas::apps
