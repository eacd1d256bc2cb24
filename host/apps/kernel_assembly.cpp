#include "kernel_assembly.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

#include <dlfcn.h>
#include <elf.h>
#include <fmt/format.h>

#include "command_line/child_process.hpp"
#include "command_line/scratch.hpp"
#include "compute/cpp/host_kernels.hpp"
#include "compute/opencl/devices.hpp"
#include "compute/opencl/programs.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

namespace fs = std::filesystem;

/// A loop of a kernel's code, which ends with a jump back.
struct Loop {
    std::uint64_t first, last; ///< addresses of its first instruction and of the jump
    std::size_t instructions = 0;
    std::size_t vectors = 0; ///< instructions that compute with several numbers at once
    unsigned bits = 0;       ///< bits of the widest of these
};

struct Instruction {
    std::uint64_t address;
    std::string text; ///< mnemonic and operands
};

std::optional<std::uint64_t> hexadecimal(std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    return error == std::errc{} && end != text.data() ? std::optional{value} : std::nullopt;
}

/// Instructions from lines such as " 1a2b:\tadd %eax,%ebx".
std::vector<Instruction> instructions_in(const std::string& listing) {
    std::vector<Instruction> all;
    std::istringstream lines{listing};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(":\t"), begin = line.find_first_not_of(' ');
        if (colon == line.npos || begin > colon) continue;
        const auto address = hexadecimal(std::string_view{line}.substr(begin, colon - begin));
        if (address) all.push_back({*address, line.substr(colon + 2)});
    }
    return all;
}

/// Bits of the vectors that an instruction computes with; 0 if it computes with single numbers or
/// only moves vectors.
unsigned vector_bits(const std::string& instruction) {
    // Bitwise instructions do not count, because compilers use those of vectors to make single
    // numbers 0 or positive.
    static const std::regex of_x86{
        "v?p?(add|sub|mul|div|sqrt|max|min|fn?m|cmp|cvt|sll|srl|sra|abs|round)\\S*"};
    static const std::regex of_arm{".*\\bv\\d+\\.(16b|8h|4s|2d)\\b.*"};
    if (std::regex_match(instruction, of_arm)) return 128;
    const std::string mnemonic = instruction.substr(0, instruction.find_first_of(" \t"));
    if (!std::regex_match(mnemonic, of_x86)) return 0;
    const bool single = mnemonic.ends_with("ss") || mnemonic.ends_with("sd");
    for (const auto& [name, bits] : {std::pair{"%zmm", 512U}, {"%ymm", 256U}, {"%xmm", 128U}})
        if (!single && instruction.find(name) != instruction.npos) return bits;
    return 0;
}

/// The target of a jump; nothing for other instructions.
std::optional<std::uint64_t> target_of(const Instruction& instruction) {
    static const std::regex jump{
        "(j[a-z]+|b\\.?[a-z]*|cbn?z|tbn?z)\\s+(?:\\S+,\\s*)*([0-9a-f]+)( .*)?"};
    std::smatch parts;
    if (!std::regex_match(instruction.text, parts, jump)) return std::nullopt;
    return hexadecimal(parts[2].str());
}

/// Loops, from the target of a jump back to the last jump there.
std::map<std::uint64_t, std::uint64_t> ranges_of_loops(const std::vector<Instruction>& code) {
    std::map<std::uint64_t, std::uint64_t> ranges;
    for (const Instruction& jump : code) {
        const auto target = target_of(jump);
        if (!target || *target > jump.address || *target < code.front().address) continue;
        ranges[*target] = jump.address; // the last jump stays
    }
    return ranges;
}

std::vector<Loop> loops_in(const std::vector<Instruction>& code) {
    std::vector<Loop> loops;
    for (const auto& [first, last] : ranges_of_loops(code)) {
        Loop loop{first, last};
        for (const Instruction& inside : code) {
            if (inside.address < first || inside.address > last) continue;
            const unsigned bits = vector_bits(inside.text);
            ++loop.instructions;
            loop.vectors += bits > 0 ? 1 : 0;
            loop.bits = std::max(loop.bits, bits);
        }
        loops.push_back(loop);
    }
    return loops;
}

std::string with_loops(const std::string& title, const std::string& listing) {
    const std::vector<Instruction> code = instructions_in(listing);
    if (code.empty()) throw Error("objdump shows no instructions of " + title);
    const std::vector<Loop> loops = loops_in(code);
    std::string text =
        fmt::format("// {}: {} instructions, {} loops\n", title, code.size(), loops.size());
    for (const Loop& loop : loops) {
        text += fmt::format("// loop {:x} to {:x}: {} instructions", loop.first, loop.last,
                            loop.instructions);
        text += loop.bits > 0 ? fmt::format(", {} on {} numbers of 32 bits at once\n", loop.vectors,
                                            loop.bits / 32)
                              : ", on one number each\n";
    }
    return text + listing;
}

std::string disassembled(const fs::path& file, std::vector<std::string> options) {
    constexpr std::chrono::seconds limit = std::chrono::minutes{2};
    options.insert(options.begin(), {"objdump", "--disassemble", "--no-show-raw-insn", "--wide"});
    options.push_back(file.string());
    // env searches for the program as a shell does.
    const ChildResult result = run_child("/usr/bin/env", options, limit);
    if (result.exit_code == 0) return result.output;
    throw Error("objdump does not run; install it (package binutils)");
}

/// The program or library that holds the kernels. The name of the program itself may be no path.
fs::path file_of(const Dl_info& place) {
    const fs::path named = place.dli_fname;
    return named.has_parent_path() ? named : fs::read_symlink("/proc/self/exe");
}

/// The address from which the file's addresses are counted.
std::uintptr_t origin_of(const Dl_info& place, const fs::path& file) {
    Elf64_Ehdr header{};
    std::ifstream{file, std::ios::binary}.read(reinterpret_cast<char*>(&header), sizeof header);
    return header.e_type == ET_EXEC ? 0 : reinterpret_cast<std::uintptr_t>(place.dli_fbase);
}

std::string assembly_of_cpp(const compute::Kernel& kernel) {
    const auto address = [](const compute::HostKernel& form) {
        return reinterpret_cast<std::uintptr_t>(form.run);
    };
    const auto forms = compute::host_kernels();
    const compute::HostKernel* own = compute::find_form(forms, kernel.name, kernel.defines);
    if (own == nullptr) {
        throw UsageError(fmt::format("the kernel {} has barriers and does not run as C++; "
                                     "--device names an OpenCL device",
                                     kernel.name));
    }
    // Kernels follow each other. Other code comes after the last one.
    constexpr std::uintptr_t longest = 1U << 16U;
    std::uintptr_t end = address(*own) + longest;
    for (const compute::HostKernel& other : forms)
        if (address(other) > address(*own)) end = std::min(end, address(other));
    Dl_info place{};
    if (::dladdr(reinterpret_cast<const void*>(own->run), &place) == 0)
        throw Error("the kernels as C++ are not found in this program");
    const fs::path file = file_of(place);
    const std::uintptr_t origin = origin_of(place, file);
    const auto option = [&](const char* name, std::uintptr_t at) {
        return fmt::format("--{}-address={:#x}", name, at - origin);
    };
    return with_loops(fmt::format("{} as C++, {}", kernel.name, compute::host_instruction_set()),
                      disassembled(file, {option("start", address(*own)), option("stop", end)}));
}

/// The library that PoCL has made of a kernel; empty if the device is not of PoCL.
fs::path library_in(const fs::path& cache, std::string_view kernel) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{cache})
        if (entry.path().filename() == std::string{kernel} + ".so") return entry.path();
    return {};
}

std::string assembly_of_opencl(const compute::Kernel& kernel, const std::string& device_name) {
    const Scratch scratch;
    // PoCL keeps libraries in this folder. It is set before PoCL is loaded.
    ::setenv("POCL_CACHE_DIR", scratch.folder.c_str(), 1);
    ::setenv("POCL_KERNEL_CACHE", "1", 1);
    const compute::OpenClDevice device = compute::find_opencl_devices(device_name).front();
    const std::vector<unsigned char> binary = compute::binary_of(device, kernel);
    const std::string title = fmt::format("{} on {}", kernel.name, device.description());
    if (const fs::path library = library_in(scratch.folder, kernel.name); !library.empty())
        return with_loops(title, disassembled(library, {}));
    const auto is_text = [](unsigned char c) { return c >= ' ' || c == '\n' || c == '\t'; };
    std::string text{binary.begin(), binary.end()};
    text.erase(text.find_last_not_of('\0') + 1);
    if (!text.empty() && std::ranges::all_of(text, is_text))
        return fmt::format("// {}\n{}", title, text);
    throw Error(fmt::format("{} hands out {} bytes of {} that are neither text nor a library of "
                            "PoCL's; take another device",
                            device.description(), binary.size(), kernel.name));
}

} // namespace

std::string assembly_of(const compute::Kernel& kernel, const std::string& device) {
    return device.empty() ? assembly_of_cpp(kernel) : assembly_of_opencl(kernel, device);
}

} // namespace lineatlas::apps
