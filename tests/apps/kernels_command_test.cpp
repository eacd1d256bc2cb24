// `lineatlas kernels`: the list, and one kernel with its arguments.

#include "lineatlas/compute_device.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

TEST_F(Tool, ListsEveryKernelOnce) {
    const Result list = run("kernels");
    ASSERT_EQ(list.exit_code, 0) << list.output;
    std::istringstream lines{list.output};
    std::string program, kernel, stage, forms;
    std::getline(lines, forms); // the heading
    std::set<std::string> listed;
    while (lines >> program >> kernel >> stage && std::getline(lines, forms)) {
        EXPECT_TRUE(listed.insert(kernel).second) << kernel;
        EXPECT_EQ(program, stage + ".cl");
    }
    for (const compute::Kernel& known : compute::all_kernels()) {
        EXPECT_TRUE(listed.contains(std::string{known.name})) << known.name;
        EXPECT_NE(list.output.find(known.defines), std::string::npos) << known.defines;
    }
}

/// The description that `kernels NAME` prints before the source.
std::string description_in(const std::string& output) {
    return output.substr(0, output.find("\n\n#line"));
}

TEST_F(Tool, PrintsEachKernelWithWhatItWorksOn) {
    for (const compute::Kernel& kernel : compute::all_kernels()) {
        const Result printed = run("kernels " + std::string{kernel.name});
        ASSERT_EQ(printed.exit_code, 0) << printed.output;
        const std::string about = description_in(printed.output);
        EXPECT_EQ(printed.output.substr(about.size() + 2), source_of(kernel));
        EXPECT_NE(about.find("\n// parameters, " + std::to_string(kernel.parameter_size) +
                             " bytes:\n// typedef struct "),
                  std::string::npos)
            << about;
        EXPECT_NE(about.find("Parameters;\n"), std::string::npos) << about;
        EXPECT_NE(about.find("\n// files: " + kernel.file() + ", "), std::string::npos) << about;
        for (const compute::KernelTable& table : kernel.tables)
            EXPECT_NE(about.find("\n// " + std::string{table.name} + ' '), std::string::npos)
                << about;
    }
}

TEST_F(Tool, SaysWhatATableIs) {
    const std::string about = description_in(run("kernels temporal").output);
    for (const char* row : {"\n// clipped                 in         ClippedSegment        48\n",
                            "\n// ranges                  inout      uint                   4\n",
                            "\n// alpha                   inout      uchar                  1"})
        EXPECT_NE(about.find(row), std::string::npos) << about;
    EXPECT_NE(about.find("\n//     la_uint history; /* LA_HISTORY_* */\n"), std::string::npos);
}

TEST_F(Tool, PrintsKernelsOfAFolder) {
    fs::copy(LINEATLAS_SOURCE_DIR "/kernels", path("mine"), fs::copy_options::recursive);
    std::ofstream{path("mine/facing.cl"), std::ios::app} << "/* mine */\n";
    ::setenv("LINEATLAS_KERNEL_DIR", path("mine").c_str(), 1);
    EXPECT_NE(run("kernels facing").output.find("\n/* mine */\n"), std::string::npos);
    fs::remove(path("mine/facing.cl"));
    expect_refused("kernels facing", 1, "facing.cl");
    ::unsetenv("LINEATLAS_KERNEL_DIR");
}

/// An imitated objdump that prints a known listing: a loop on 16 numbers within a loop on single
/// numbers.
TEST_F(Tool, FindsTheLoopsInAssembly) {
    write("objdump", "#!/bin/sh\nprintf '  10:\\tmov    %%rdi,%%rax\\n"
                     "  14:\\tvaddss %%xmm0,%%xmm1,%%xmm1\\n"
                     "  18:\\tvmovups (%%rdi),%%zmm2\\n"
                     "  1e:\\tvmulps %%zmm2,%%zmm3,%%zmm3\\n"
                     "  24:\\tjb     18 <kernel+0x8>\\n"
                     "  26:\\tjne    14 <kernel+0x4>\\n"
                     "  28:\\tjmp    90 <elsewhere>\\n"
                     "  2a:\\tret\\n'\n");
    fs::permissions(path("objdump"), fs::perms::owner_all);
    const std::string search = "PATH=" + folder_.string() + ":$PATH " LINEATLAS_TOOL;
    const Result shown = shell(search + " kernels facing --assembly 2>&1");
    EXPECT_EQ(shown.exit_code, 0) << shown.output;
    for (const char* line :
         {": 8 instructions, 2 loops\n",
          "// loop 14 to 26: 5 instructions, 1 on 16 numbers of 32 bits at once\n",
          "// loop 18 to 24: 3 instructions, 1 on 16 numbers of 32 bits at once\n",
          "\n  2a:\tret\n"})
        EXPECT_NE(shown.output.find(line), std::string::npos) << line << shown.output;
    write("objdump", "#!/bin/sh\nexit 1\n");
    const Result without = shell(search + " kernels facing --assembly 2>&1");
    EXPECT_EQ(without.exit_code, 1);
    EXPECT_NE(without.output.find("objdump does not run; install it"), std::string::npos);
}

TEST_F(Tool, ShowsWhatCompilersMakeOfAKernel) {
    if (std::system("objdump --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no objdump";
    for (const std::string device : {"", " --device opencl:portable"}) {
        const Result shown = run("kernels density_smooth --assembly" + device);
        EXPECT_EQ(shown.exit_code, 0) << shown.output;
        EXPECT_NE(shown.output.find("// loop "), std::string::npos) << shown.output.substr(0, 400);
        EXPECT_NE(shown.output.find(device.empty() ? "density_smooth as C++, "
                                                   : "density_smooth on opencl: "),
                  std::string::npos);
        EXPECT_NE(shown.output.find("ret"), std::string::npos);
    }
    EXPECT_NE(run("kernels atlas --assembly --form=-DPROBES_PER_AXIS=1").output,
              run("kernels atlas --assembly --form=-DPROBES_PER_AXIS=4").output);
}

TEST_F(Tool, RefusesFormsThatThereAreNot) {
    expect_refused("kernels atlas --assembly --form=-DPROBES_PER_AXIS=9", 2,
                   "has no form \"-DPROBES_PER_AXIS=9\"");
    expect_refused("kernels scan_tiles_apply --assembly", 2, "has barriers");
    expect_refused("kernels facing --assembly --device opencl:nowhere", 2, "opencl:nowhere");
    expect_refused("kernels --assembly", 2, "NAME");
}

#ifdef LINEATLAS_COUNTED
TEST_F(Tool, SaysWhyKernelsTakeTheirTime) {
    const std::string draw = "draw --scene clevis --size 200x150 -o " + path("c.png");
    const Result drawn = run(draw + " --method atlas --kernels - --kernels " + path("k.json") +
                             " --kernels " + path("k.csv") + " --kernels " + path("k.svg"));
    ASSERT_EQ(drawn.exit_code, 0) << drawn.output;
    EXPECT_NE(drawn.output.find("\nproject_clip  project_clip "), std::string::npos);
    EXPECT_EQ(drawn.output.find("unknown"), std::string::npos) << drawn.output;
    EXPECT_NE(read(path("k.json")).find("\"kernel\": \"project_clip\""), std::string::npos);
    EXPECT_NE(read(path("k.csv")).find("\nproject_clip,project_clip,"), std::string::npos);
    EXPECT_NE(read(path("k.svg")).find("<title>project_clip project_clip: "), std::string::npos);
    // Either the CPU's events are there, or one line says why they are not.
    EXPECT_NE(drawn.output.find("M instr.  per cycle"), std::string::npos) << drawn.output;
    EXPECT_EQ(drawn.output.find("\nno instructions, cycles and cache misses: ") !=
                  std::string::npos,
              read(path("k.json")).find("\"cycles\": null") != std::string::npos);
    EXPECT_EQ(read(path("k.json")).find("\"cores\": null"), std::string::npos);
}

TEST_F(Tool, SaysWhatADriverTellsOfKernels) {
    const Result drawn = run(
        "draw --scene clevis --size 200x150 --method atlas --device opencl:portable -o " +
        path("c.png") + " --repeat 2 --kernels " + path("k.json") + " --profile " + path("t.json"));
    ASSERT_EQ(drawn.exit_code, 0) << drawn.output;
    for (const char* key : {"\"largest_group\": ", "\"group_multiple\": ", "\"local_bytes\": ",
                            "\"private_bytes\": ", "\"bound\": \"", "\"cores\": "}) {
        EXPECT_NE(read(path("k.json")).find(key), std::string::npos) << key;
        EXPECT_NE(read(path("t.json")).find(key), std::string::npos) << key;
    }
}
#else
TEST_F(Tool, WritesTheProfileWithoutKernels) {
    const Result drawn = run("draw --scene clevis --size 200x150 -o " + path("c.png") +
                             " --kernels - --profile " + path("p.csv"));
    EXPECT_EQ(drawn.exit_code, 2) << drawn.output;
    EXPECT_NE(drawn.output.find("kernels do not count"), std::string::npos) << drawn.output;
    EXPECT_NE(read(path("p.csv")).find("project_clip"), std::string::npos);
}
#endif

TEST_F(Tool, KernelsAreMeasuredOfOnePicture) {
    const std::string draw = "draw --scene clevis --size 200x150 -o ";
    expect_refused(draw + path("c.png") + " --kernels k.txt", 2, ".json or .csv or .svg");
    expect_refused(draw + path("%d.png") + " --turntable 2 --kernels -", 2, "one picture");
    expect_refused(draw + path("c.png") + " --compare-with cpp --kernels -", 2,
                   "leave out --turntable, --camera-path and --compare-with");
    expect_refused(draw + path("c.svg") + " --kernels " + path("c.svg"), 2, "c.svg");
}

TEST_F(Tool, NamesAKernelThatThereIsNot) {
    expect_refused("kernels project", 2, "there is no kernel \"project\"");
}

} // namespace
} // namespace lineatlas::test
