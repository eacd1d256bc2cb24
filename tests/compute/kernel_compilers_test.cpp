// Every program, in every form that the tuning table gives a device, is OpenCL C 1.2 without
// extensions to compilers of three kinds, and no work-group needs more local memory than each
// device has. clang stands for compilers of drivers that are not here. Of their quirks one can be
// seen in the sources: functions that are given local memory must be inlined.
// What kernels need of a GPU's processors is known here, too.

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "compute/kernels.hpp"
#include "compute/opencl/tuning_table.hpp"
#include "compute/stages/kernel_forms.hpp"
#include "planted_error.hpp"
#include "sources/sources.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

/// The least that OpenCL 1.2 promises (CL_DEVICE_LOCAL_MEM_SIZE).
constexpr std::size_t least_local_memory = 32 * 1024;
constexpr std::size_t largest_group = 1024; // of what OpenCL devices have

struct Program {
    std::string file, source, options;
    auto operator<=>(const Program&) const = default;
};

std::string without_comments(std::string source) {
    for (std::size_t begin = 0; (begin = source.find("/*", begin)) != std::string::npos;)
        source.erase(begin, source.find("*/", begin) + 2 - begin);
    return source;
}

/// Those of `options` that the source can tell apart.
std::string that_matter(const std::string& options, const std::string& source) {
    std::istringstream words{options};
    std::string result;
    for (std::string word; words >> word;) {
        const std::size_t name = std::string_view{"-D"}.size();
        if (source.find(word.substr(name, word.find('=') - name)) != std::string::npos)
            result += ' ' + word;
    }
    return result;
}

/// What devices of the table have kernels compiled for: as it says, or where the device has the
/// least local memory; without atomics of 64 bits or with them.
std::set<std::string> forms(bool least_memory, bool long_atomics = false) {
    const compute::TuningTable table{kernel_source("tuning.toml"), "tuning.toml"};
    std::set<std::string> result;
    for (const compute::OpenClDevice& device : table.examples()) {
        compute::Tuning tuning = compute::tuning_for(device);
        if (least_memory)
            tuning = compute::within_groups(tuning, {largest_group, least_local_memory});
        tuning.long_atomics = long_atomics;
        result.insert(compute::compiler_options(tuning));
    }
    return result;
}

/// `stage`: of that one alone; empty: of all.
std::set<Program> programs(const std::set<std::string>& forms, std::string_view stage) {
    std::set<Program> result;
    for (const compute::Kernel& kernel : compute::all_kernels()) {
        if (!stage.empty() && kernel.stage != stage) continue;
        const std::string source = compute::source_of(kernel);
        const std::string code = without_comments(source);
        for (const std::string& form : forms)
            result.insert({kernel.file(), source,
                           that_matter(form, code) + ' ' + std::string{kernel.defines}});
    }
    return result;
}

struct Output {
    bool good = false;
    std::string text;
};

Output run(const std::string& command) {
    FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
    Output output;
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), part.size(), pipe) != nullptr) output.text += part.data();
    output.good = ::pclose(pipe) == 0;
    return output;
}

/// What clang says of all programs with `arguments`, by the file and options of each.
std::map<std::string, Output> compile(const std::set<Program>& programs,
                                      const std::string& arguments,
                                      const std::string& compiler = "clang") {
    const TemporaryFolder folder;
    const std::vector<Program> list{programs.begin(), programs.end()};
    std::vector<Output> outputs(list.size());
    std::atomic<std::size_t> next = 0;
    {
        std::vector<std::jthread> threads;
        for (unsigned i = 0; i < std::max(2U, std::thread::hardware_concurrency()); ++i) {
            threads.emplace_back([&] {
                for (std::size_t i = next++; i < list.size(); i = next++) {
                    const auto file = folder.path() / std::to_string(i);
                    std::ofstream{file} << list[i].source;
                    outputs[i] = run(compiler +
                                     " -x cl -cl-std=CL1.2 -D__OPENCL_VERSION__=120 -Xclang "
                                     "-finclude-default-header -nogpulib -pedantic-errors " +
                                     arguments + list[i].options + " " + file.string());
                }
            });
        }
    }
    std::map<std::string, Output> result;
    for (std::size_t i = 0; i < list.size(); ++i)
        result[list[i].file + list[i].options] = std::move(outputs[i]);
    return result;
}

/// What is wrong with programs by compilers of three kinds, by target, file and options.
std::map<std::string, std::string> refusals(std::string_view stage = {}) {
    std::map<std::string, std::string> result;
    std::set<std::string> all = forms(false);
    all.merge(forms(true));
    for (const std::string target : {"spir64", "nvptx64--nvidiacl", "amdgcn--amdhsa"}) {
        std::set<std::string> own = all;
        // Of NVIDIA's compiler clang does not know that it has atomics of 64 bits.
        if (!target.starts_with("nvptx64")) own.merge(forms(false, true));
        for (const auto& [program, output] :
             compile(programs(own, stage), "-fsyntax-only --target=" + target)) {
            if (!output.good) result[target + ' ' + program] = output.text;
        }
    }
    return result;
}

/// Whether a program names local memory anywhere but where the language's header defines how.
bool names_local_memory(const Program& program) {
    std::istringstream lines{without_comments(program.source)};
    for (std::string line; std::getline(lines, line);)
        if (line.find("LOCAL_TABLE(") != line.npos || line.find("__local") != line.npos)
            if (line.front() != '#') return true;
    return false;
}

/// Bytes that a work-group of each kernel that has local memory needs on a device with the least of
/// it, or more than that, as clang has laid them out for a GPU of AMD's; throws if it says nothing.
std::map<std::string, std::size_t> local_memory(std::string_view stage = {}) {
    std::map<std::string, std::size_t> result;
    std::set<Program> own = programs(forms(true), stage);
    std::erase_if(own, [](const Program& program) { return !names_local_memory(program); });
    for (const auto& [program, output] :
         compile(own, "-O0 -S -o - --target=amdgcn--amdhsa -mcpu=gfx900")) {
        std::istringstream lines{output.text};
        std::string kernel;
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words{line};
            std::string word;
            words >> word;
            if (word == ".amdhsa_kernel") words >> kernel;
            if (word == ".amdhsa_group_segment_fixed_size")
                words >> result[program + ": " + kernel];
        }
        if (kernel.empty()) throw Error(program + " was not laid out: " + output.text);
    }
    return result;
}

/// What a work-item of a kernel needs of a GPU: vector registers, and bytes of private memory that
/// did not go into them.
struct Needs {
    unsigned registers = 0, memory = 0;
};

/// OpenCL's own functions for a GPU of AMD's, as clang links them.
constexpr const char* functions_of_opencl = "/usr/lib/clc/gfx900-amdgcn-mesa-mesa3d.bc";

/// For that GPU; behind it stands what is compiled.
const std::string for_a_gpu =
    std::string{"-O2 -S -o - --target=amdgcn-mesa-mesa3d -mcpu=gfx900 -Xclang "
                "-mlink-builtin-bitcode -Xclang "} +
    functions_of_opencl;

/// A clang of a version that reads these functions; "" if there is none.
std::string compiler_of_needs() {
    for (const char* compiler :
         {"clang", "clang-15", "clang-16", "clang-17", "clang-18", "clang-19", "clang-20"})
        if (run(std::string{"echo '__kernel void f(void) {}' | "} + compiler +
                " -nogpulib -x cl -cl-std=CL1.2 " + for_a_gpu + " -")
                .good)
            return compiler;
    return {};
}

/// The most that any variant needs of those that a GPU of no name launches.
std::map<std::string, Needs> needs_of_gpus(std::string_view stage = {}) {
    compute::OpenClDevice gpu;
    gpu.is_gpu = true;
    const compute::Tuning tuning = compute::tuning_for(gpu);
    std::set<std::string> launched;
    for (const compute::KernelForm& form : compute::kernel_forms(compute::stage_names(), 3, tuning))
        launched.emplace(form.kernel->name);
    std::map<std::string, Needs> result;
    for (const auto& [program, output] :
         compile(programs({compute::compiler_options(tuning)}, stage), for_a_gpu,
                 compiler_of_needs())) {
        if (!output.good) throw Error(program + " does not compile: " + output.text);
        std::istringstream lines{output.text};
        std::string function;
        for (std::string line; std::getline(lines, line);) {
            const std::size_t end = line.find(':');
            if (end == line.npos) continue;
            const std::string name = line.substr(0, end);
            if (name.find_first_of(" ;.") == name.npos) function = name;
            if (!launched.contains(function)) continue;
            Needs& needs = result[function];
            const auto more = [&](unsigned& most) {
                most = std::max(most, static_cast<unsigned>(std::stoul(line.substr(end + 1))));
            };
            if (name == "; NumVgprs") more(needs.registers);
            if (name == "; ScratchSize") more(needs.memory);
        }
    }
    return result;
}

constexpr unsigned most_registers = 96; // as many leave room for two waves on a processor

/// Kernels that need more registers than that, or private memory: how much at most, with some to
/// spare for what versions of clang differ by, and why.
struct Exception {
    const char* kernel;
    Needs most;
    const char* why;
};
constexpr Exception exceptions[] = {
    {"depth_pairs", {136, 352}, "the corners of triangles that planes of the view cut; few are"},
    {"planes", {96, 2560}, "the vertices of a cluster, each placed once"},
    {"fill_colors", {96, 2560}, "the vertices of a cluster, each placed once"},
    {"chain_link", {96, 160}, "the segments that meet at a vertex"},
    {"filter_count", {144, 160}, "the runs of a line that may still change"},
    {"filter_write", {144, 160}, "the runs of a line that may still change"},
    {"halo_cut", {96, 96}, "the pieces that a run is cut into"},
    {"project_clip", {96, 32}, "registers that are spilled"},
    {"surfaces_faces", {128, 0}, "two faces and a tile at the same time"},
    {"surfaces_occluders", {136, 0}, "two faces and a tile at the same time"},
    {"tile_lists_count", {112, 0}, "a face's sides and its plane, in a tile"},
    {"tile_lists_fill", {112, 0}, "a face's sides and its plane, in a tile"},
    {"visible_cut", {184, 288}, "the visible parts of a piece"},
    {"visible_parts", {184, 288}, "the visible parts of a piece"},
};

/// Functions that are given local memory, be it in a struct, and are not INLINED.
std::set<std::string> not_inlined() {
    static const std::regex structs{R"(typedef struct (\w+) \{[^{}]*__local[^{}]*\})"};
    static const std::regex functions{R"(\n(\w+) [\w ]*?\b(\w+)\(([^()]*)\) \{)"};
    std::set<std::string> result;
    for (const compute::Kernel& kernel : compute::all_kernels()) {
        const std::string code = without_comments(compute::source_of(kernel));
        std::string given = "__local";
        for (std::sregex_iterator it{code.begin(), code.end(), structs}, end; it != end; ++it)
            given += "|\\b" + it->str(1) + "\\*";
        const std::regex local{given};
        for (std::sregex_iterator it{code.begin(), code.end(), functions}, end; it != end; ++it) {
            if (std::regex_search(it->str(3), local) && it->str(1) != "INLINED")
                result.insert(it->str(2));
        }
    }
    return result;
}

TEST(KernelSources, FunctionsWithLocalMemoryAreInlined) {
    EXPECT_EQ(not_inlined(), std::set<std::string>{});
}

TEST(KernelSources, FunctionsThatAreNotInlinedAreFound) {
    for (const auto& [file, name] : {std::pair{"depth_tile.h", "begin_tile"}, // in a struct
                                     std::pair{"strokes.cl", "draw_stroke"}}) {
        const std::string start = std::string{" void "} + name + '(';
        const PlantedError error{file, "INLINED" + start, "static" + start};
        EXPECT_EQ(not_inlined(), std::set<std::string>{name});
    }
}

class KernelCompilers : public testing::Test {
  protected:
    void SetUp() override {
        const Output targets = run("clang --print-targets");
        if (!targets.good) GTEST_SKIP() << "there is no clang (apt install clang)";
        for (const char* target : {"nvptx64", "amdgcn"}) {
            if (targets.text.find(target) == std::string::npos)
                GTEST_SKIP() << "this clang does not know " << target;
        }
    }
};

TEST_F(KernelCompilers, TakeEveryProgramInEveryForm) {
    EXPECT_GE(forms(false).size(), 3U) << "a CPU's, a GPU's and rusticl's";
    for (const auto& [program, text] : refusals()) ADD_FAILURE() << program << ":\n" << text;
}

TEST_F(KernelCompilers, NeedNoMoreLocalMemoryThanEveryDeviceHas) {
    std::size_t most = 0;
    for (const auto& [kernel, bytes] : local_memory()) {
        EXPECT_LE(bytes, least_local_memory) << kernel;
        most = std::max(most, bytes);
    }
    EXPECT_GT(most, least_local_memory / 4) << "tiles have been measured";
}

class KernelNeeds : public KernelCompilers {
  protected:
    void SetUp() override {
        KernelCompilers::SetUp();
        if (compiler_of_needs().empty())
            GTEST_SKIP() << "there is no clang of the version of " << functions_of_opencl;
    }
};

TEST_F(KernelNeeds, AreWhatAGpuHas) {
    const std::map<std::string, Needs> needs = needs_of_gpus();
    EXPECT_GT(needs.size(), 60U);
    for (const auto& [kernel, own] : needs) {
        const auto* const known = std::ranges::find(exceptions, kernel, &Exception::kernel);
        const Needs most = known != std::end(exceptions) ? known->most : Needs{most_registers, 0};
        EXPECT_LE(own.registers, most.registers) << kernel;
        EXPECT_LE(own.memory, most.memory) << kernel;
    }
    for (const Exception& exception : exceptions)
        EXPECT_TRUE(needs.contains(exception.kernel)) << exception.kernel << ": " << exception.why;
}

TEST_F(KernelNeeds, AnArrayThatIsNotInRegistersIsSeen) {
    const PlantedError error{"facing.cl", "    const uint i =",
                             "    uint many[100];\n"
                             "    for (uint k = 0; k < 100; ++k) many[k] = triangles[k];\n"
                             "    if (many[triangles[0] % 100] == 77) front[1] = 1;\n"
                             "    const uint i ="};
    EXPECT_GE(needs_of_gpus("facing")["facing"].memory, 400U);
}

TEST_F(KernelCompilers, RefuseWhatOpenClDoesNotHave) {
    const std::pair<const char*, const char*> planted[] = {
        {"#define all_of(...) __VA_ARGS__", "variadic macros"},
        {"static int two(void) { return ({ 2; }); }", "GNU statement expression"}};
    for (const auto& [text, complaint] : planted) {
        const PlantedError error{"shared/language.h", "#define FUNCTION static",
                                 std::string{"#define FUNCTION static\n"} + text};
        const auto found = refusals("facing");
        EXPECT_EQ(found.size(), 3U) << "each compiler: " << text;
        for (const auto& [program, said] : found)
            EXPECT_NE(said.find(complaint), std::string::npos) << program << said;
    }
}

TEST_F(KernelCompilers, MeasureLocalMemory) {
    const PlantedError error{"facing.cl", "    const uint i =",
                             "    LOCAL_TABLE(uint, large, 10240);\n"
                             "    large[args.count % 10240] = 1;\n"
                             "    const uint i ="};
    const auto bytes = local_memory("facing");
    ASSERT_EQ(bytes.size(), 1U);
    EXPECT_EQ(bytes.begin()->second, 40U * 1024);
}

} // namespace
} // namespace lineatlas::test
