#include "quirks.hpp"

#include <algorithm>

namespace lineatlas::compute {
namespace {

constexpr std::string_view pocl = "Portable Computing Language";
constexpr std::string_view rusticl = "rusticl";

constexpr std::string_view oclgrind = "Oclgrind";

constexpr Quirk quirks[] = {
    {.platform = rusticl,
     .what = "On llvmpipe a work-item leaves its loops, without an error, after 65,535 rounds in "
             "all (LP_MAX_TGSI_LOOP_ITERATIONS in Mesa's gallivm).",
     .remedy = "within_quirks: shorter chunks and blocks, fewer clusters at once",
     .seen_with = "Mesa 22.3.6",
     .link = "https://github.com/ggml-org/llama.cpp/pull/13813"},
    {.platform = rusticl,
     .what = "clCreateProgramWithBinary panics (\"unknown version\") and ends the process if the "
             "binary is not one of its own.",
     .remedy =
         "ProgramCache: the whole key is compared, with the driver's version, and the content "
         "checked, before the driver sees it",
     .seen_with = "Mesa 22.3.6",
     .link = "https://gitlab.freedesktop.org/mesa/mesa/-/blob/22.3/src/gallium/frontends/rusticl/"
             "core/program.rs"},
    {.platform = rusticl,
     .what = "Unmapping a buffer over host memory (CL_MEM_USE_HOST_PTR) can return "
             "CL_INVALID_VALUE.",
     .remedy = "the round trip of glpasses/interop/connect.cpp fails, and buffers are copied",
     .seen_with = "Mesa 22.3.6",
     .link = "https://registry.khronos.org/OpenCL/sdk/1.2/docs/man/xhtml/"
             "clEnqueueUnmapMemObject.html"},
    {.platform = pocl,
     .what = "clCreateContext takes the properties of an EGL context and succeeds, although "
             "nothing can be shared.",
     .remedy = "glpasses/interop/connect.cpp asks for the extension cl_khr_gl_sharing first",
     .seen_with = "PoCL 3.1",
     .link = "https://registry.khronos.org/OpenCL/sdk/3.0/docs/man/html/"
             "cl_khr_gl_sharing__context.html"},
    {.platform = pocl,
     .what = "A work-group function is built for every local size and kind of grid at the first "
             "launch, about 40 ms each.",
     .remedy = "local sizes are fixed per device (kernels/tuning.toml); benchmarks warm up first",
     .seen_with = "PoCL 3.1",
     .link = "https://pocl.sourceforge.net/docs/html/_sources/kernel_compiler.rst.txt"},
    {.platform = pocl,
     .what = "A program's binary holds functions for any work-group size; asking for it builds "
             "them all.",
     .remedy = "program_cache in kernels/tuning.toml, by measurement: docs/devices.md",
     .seen_with = "PoCL 3.1",
     .link = "https://github.com/pocl/pocl/commit/44100cf8cc97c2258aed3bf6a2e412121cdbdc79"},
    {.platform = pocl,
     .what =
         "What a function writes by a pointer into local memory is lost, unless the function is "
         "inlined. LLVM 21 inlines fewer of them than 14 to 18 did.",
     .remedy =
         "INLINED (kernels/shared/language.h), which kernel_compilers_test asks of every function "
         "that is given local memory; docs/devices.md has a small program that shows it",
     .seen_with = "PoCL 3.1 (told noinline) and 7.1",
     .link = "https://github.com/pocl/pocl/issues"},
    {.platform = pocl,
     .what = "Building a program prints how many warnings its compiler has (\"4 warnings "
             "generated.\"), such as those of vectors that a CPU's calls pass otherwise with AVX.",
     .remedy = "quirk_options: warnings are off",
     .seen_with = "PoCL 6.0",
     .link = "https://registry.khronos.org/OpenCL/sdk/3.0/docs/man/html/clBuildProgram.html"},
    {.platform = oclgrind,
     .what = "Optimised programs hold intrinsics of LLVM that it does not know, and their kernels "
             "cannot be made.",
     .remedy = "quirk_options: nothing is optimised",
     .seen_with = "Oclgrind 21.10",
     .link = "https://github.com/jrprice/Oclgrind/issues"},
    {.platform = oclgrind,
     .what = "Its LLVM and that of Mesa's llvmpipe take each other's functions: the process "
             "crashes when either compiles after the other.",
     .remedy = "collides_with_llvmpipe: glpasses/interop/connect.cpp refuses it beside llvmpipe",
     .seen_with = "Oclgrind 21.10, Mesa 22.3.6",
     .link = "https://github.com/jrprice/Oclgrind/issues"},
};

} // namespace

std::span<const Quirk> known_quirks() {
    return quirks;
}

Tuning within_quirks(Tuning tuning, const OpenClDevice& device) {
    if (device.platform_name == rusticl) {
        tuning.longest_chunk = 60'000;
        tuning.segment_block = std::min(tuning.segment_block, 16U);
        // A small tile, and two clusters that fill it: at most 55,000 rounds of a loop.
        tuning.depth_tile = 16;
        tuning.depth_clusters = 2;
        tuning.depth_workers = ~0U;
    }
    return tuning;
}

std::string quirk_options(const OpenClDevice& device) {
    if (device.platform_name == pocl) return "-w ";
    return device.platform_name == oclgrind ? "-cl-opt-disable " : "";
}

bool collides_with_llvmpipe(const OpenClDevice& device) {
    return device.platform_name == oclgrind;
}

bool aborts_on_foreign_binary(const OpenClDevice& device) {
    return device.platform_name == rusticl;
}

} // namespace lineatlas::compute
