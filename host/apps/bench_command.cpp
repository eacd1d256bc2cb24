#include "commands.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <unistd.h>

#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

/// Runs the benchmark program of that name, which stands beside the tool, in place of this process.
void run_benchmark(const std::string& name, const std::vector<std::string>& arguments) {
    const std::filesystem::path tool = std::filesystem::read_symlink("/proc/self/exe");
    const std::string program = (tool.parent_path() / ("lineatlas-bench-" + name)).string();
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    throw Error("cannot run \"" + program +
                "\"; the benchmarks are built with the option LINEATLAS_BENCH");
}

} // namespace

Command setup_bench(CLI::App& app) {
    app.require_subcommand(1);
    app.footer("Each takes --help for its own options.");
    for (const auto& [name, description] :
         {std::pair{"frames", "Frame times of every method beside the paper's Table 1"},
          std::pair{"kernels", "Every kernel beside a copy, std, TBB and Boost.Compute"},
          std::pair{"interop", "Handing buffers over between GL and OpenCL in each mode"},
          std::pair{"quality", "Visibility against exact ray casting"},
          std::pair{"tune", "Measure launch parameters and print a row for kernels/tuning.toml"}}) {
        app.add_subcommand(name, description)->prefix_command()->set_help_flag();
    }
    return [&app] {
        const CLI::App* chosen = app.get_subcommands().front();
        run_benchmark(chosen->get_name(), chosen->remaining());
    };
}

} // namespace lineatlas::apps
