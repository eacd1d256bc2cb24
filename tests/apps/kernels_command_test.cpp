// `lineatlas kernels`: the list, and one kernel with what it works on.

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

/// What `kernels NAME` says before the source.
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
    fs::copy(LINEATLAS_SOURCE_DIR "/kernels", path("mine"));
    std::ofstream{path("mine/facing.cl"), std::ios::app} << "/* mine */\n";
    ::setenv("LINEATLAS_KERNEL_DIR", path("mine").c_str(), 1);
    EXPECT_NE(run("kernels facing").output.find("\n/* mine */\n"), std::string::npos);
    fs::remove(path("mine/facing.cl"));
    expect_refused("kernels facing", 1, "facing.cl");
    ::unsetenv("LINEATLAS_KERNEL_DIR");
}

TEST_F(Tool, NamesAKernelThatThereIsNot) {
    expect_refused("kernels project", 2, "there is no kernel \"project\"");
}

} // namespace
} // namespace lineatlas::test
