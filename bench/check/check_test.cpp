// The check on a bundle whose programs are scripts. Whatever a script does, the check ends and
// reports it.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

namespace lineatlas::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Check : public testing::Test {
  protected:
    Check() { fs::create_directories(folder_ / "bin"), fs::create_directories(folder_ / "tests"); }
    ~Check() override { fs::remove_all(folder_); }

    void script(const std::string& name, const std::string& body) const {
        std::ofstream{folder_ / name} << "#!/bin/sh\n" << body << "\n";
        fs::permissions(folder_ / name, fs::perms::owner_all);
    }
    int run(const std::string& options) const {
        const std::string command = std::string{LINEATLAS_CHECK} + " --bundle " + folder_.string() +
                                    " --json " + json_.string() + " " + options + " >/dev/null";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    Json result() const { return Json::parse(std::ifstream{json_}); }
    /// The report for people.
    std::string markdown() const {
        std::ifstream file{fs::path{json_}.replace_extension(".md")};
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Json part(const std::string& name) const {
        const Json all = result();
        for (const Json& part : all["parts"]) {
            if (part["name"] == name) return part;
        }
        return nullptr;
    }

    fs::path folder_ =
        fs::temp_directory_path() / ("lineatlas_check_" + std::to_string(::getpid()));
    fs::path json_ = folder_ / "out.json";
};

/// The last argument names the file to write.
const char* const write_figures = R"(for last; do :; done
echo '{"gl": {"renderer": "none"}, "devices": [{"name": "one"}]}' > "${last#--json=}")";

TEST_F(Check, SurvivesPartsThatFailCrashOrAreMissing) {
    script("bin/lineatlas", write_figures);
    script("bin/lineatlas-bench-interop", "kill -SEGV $$");
    script("tests/sharing_modes_test", "echo boom >&2\nexit 3");
    script("tests/stages_test", "exit 0");
    EXPECT_EQ(run(""), 1);

    EXPECT_EQ(result()["gl"]["renderer"], "none");
    EXPECT_EQ(result()["devices"][0]["name"], "one");
    EXPECT_FALSE(result()["machine"]["kernel"].empty());
    EXPECT_EQ(part("devices")["outcome"], "ok");
    EXPECT_EQ(part("stages_test")["outcome"], "ok");
    EXPECT_EQ(part("sharing_modes_test")["exit_code"], 3);
    EXPECT_EQ(part("sharing_modes_test")["output"], "boom\n");
    EXPECT_EQ(part("interop copy")["outcome"], "crashed (Segmentation fault)");
    EXPECT_NE(part("compute_test")["outcome"], "ok") << "it is not there";
    EXPECT_EQ(result()["parts"].size(), 26U);
    EXPECT_NE(markdown().find("| interop copy | crashed (Segmentation fault) |"),
              std::string::npos);
}

TEST_F(Check, SaysWhatFailedWithItsFirstMessageAndWhatWasSkippedWhy) {
    script("tests/stages_test", R"(for last; do :; done
cat > "${last#--gtest_output=xml:}" <<'END'
<testsuites tests="3" failures="1"><testsuite name="Facing">
 <testcase name="IsRight"><failure message="a.cpp:3&#x0A;1 is not 2"/><failure message="more"/></testcase>
 <testcase name="Shares"><skipped message="a.cpp:9&#x0A;the device is not a CPU"/></testcase>
 <testcase name="Passes"/>
</testsuite></testsuites>
END
exit 1)");
    EXPECT_EQ(run("--part stages_test"), 1);
    const Json tests = part("stages_test")["tests"];
    EXPECT_EQ(tests["tests"], 3);
    EXPECT_EQ(tests["failures"], 1);
    EXPECT_EQ(tests["failed"], Json::parse(R"([{"name": "Facing.IsRight",
                                               "message": "a.cpp:3\n1 is not 2"}])"));
    EXPECT_EQ(tests["skipped"], Json::parse(R"([{"name": "Facing.Shares",
                                                "message": "a.cpp:9\nthe device is not a CPU"}])"));
}

TEST_F(Check, PassesWhereAllPartsDo) {
    script("bin/lineatlas", write_figures);
    script("bin/lineatlas-bench-interop", write_figures);
    EXPECT_EQ(run("--part devices --part 'interop copy'"), 0);
    EXPECT_EQ(result()["parts"].size(), 2U);
    EXPECT_EQ(part("interop copy")["figures"]["gl"]["renderer"], "none");
}

TEST_F(Check, TellsPeopleWhatBenchmarksMeasured) {
    script("bin/lineatlas", write_figures);
    script("bin/lineatlas-bench-frames", R"(for last; do :; done
cat > "${last#--json=}" <<'END'
{"scenes": {"ship": {"methods": {"OGL": {"ms": 1.5, "stages": {"depth": 1.25}},
                                 "SAhi": {"ms": 2.0, "stages": {"depth": 0.5, "atlas": 0.125}}}}}}
END)");
    script("bin/lineatlas-bench-interop", R"(for last; do :; done
cat > "${last#--json=}" <<'END'
{"handovers": [{"device": "one", "mode": "copy", "bytes": 65536, "to_compute_ms": 0.25,
                "to_gl_ms": 0.5, "memcpy_ms": 0.125}]}
END)");
    script("bin/lineatlas-bench-kernels", R"(for last; do :; done
cat > "${last#--json=}" <<'END'
{"benchmarks": [{"name": "scan/ours/4194304/manual_time", "real_time": 87.0,
                 "bytes_per_second": 4e11, "share_of_copy": 0.5}]}
END)");
    EXPECT_EQ(run("--part devices --part 'frames ship' --part 'interop copy' --part kernels"), 0);
    const std::string text = markdown();
    for (const char* row :
         {"| ship | SAhi | 2 | 0.75 | depth 0.5, atlas 0.125 |", "| one | copy | 64 | 0.25 | 0.5 |",
          "| scan/ours | 87 | 400 | 0.5 |", "| frames ship | ok |"})
        EXPECT_NE(text.find(row), std::string::npos) << row << " in " << text;
}

TEST_F(Check, TellsWhyKernelsTakeTheirTime) {
    script("bin/lineatlas", R"(for last; do :; done
cat > "${last#--kernels=}" <<'END'
{"roofs": {"copy_gb_per_s": 2000.0, "arithmetic_gop_per_s": 30000.0},
 "kernels": [{"stage": "atlas", "kernel": "atlas", "launches": 10, "median_us": 87.25,
              "p10_us": 80.0, "p90_us": 95.5, "bytes": 4e6, "operations": 1.5e9, "gb_per_s": 100.0,
              "gop_per_s": 15000.0, "bound": "arithmetic", "cores": null, "largest_group": 256,
              "group_multiple": 32, "local_bytes": 4096, "private_bytes": 0, "registers": 72,
              "resident_items": null}]}
END)");
    EXPECT_EQ(run("--part 'bounds atlas'"), 0);
    EXPECT_EQ(part("bounds atlas")["figures"]["kernels"][0]["registers"], 72);
    const std::string text = markdown();
    for (const char* line : {"## Why kernels take their time: a frame by atlas\n",
                             "A copy moves 2e+03 GB/s; the device does 3e+04 Gop/s.\n",
                             "| atlas | atlas | 87.2 | 80 | 95.5 | 10 | 4 | 5 | 1.5e+03 | 50 | "
                             "arithmetic |  | 4096 | 0 | 32 "
                             "| 256 | 72 |  |\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << " in " << text;
}

TEST_F(Check, ShowsPicturesOfADeviceAndOfCppBesideEachOther) {
    script("bin/lineatlas", R"(test "$1" = draw || exit 0
model=$4
while [ "$1" != -o ]; do shift; done
echo "$model" > "$2")");
    EXPECT_EQ(run("--part picture --part 'picture cpp' --part scan --part 'scan cpp'"), 0);
    const std::string text = markdown();
    for (const char* row :
         {"| ![picture](out-pictures/picture-device.png) | "
          "![picture cpp](out-pictures/picture-cpp.png) |",
          "| ![scan](out-pictures/scan-device.png) | ![scan cpp](out-pictures/scan-cpp.png) |"})
        EXPECT_NE(text.find(row), std::string::npos) << row << " in " << text;
    EXPECT_TRUE(fs::exists(folder_ / "out-pictures" / "scan-cpp.png"));
}

/// Files of one pixel, black and nearly black.
const char* const black =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNgYGAAAAAEAAH2FzhVAAAAAElFTkSuQmCC";
const char* const nearly_black =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNgZmYGAAAWAAoNgUljAAAAAElFTkSuQmCC";

TEST_F(Check, CountsPixelsThatDiffer) {
    const auto draw = [](const std::string& png) {
        return "test \"$1\" = draw || exit 0\nwhile [ \"$1\" != -o ]; do shift; done\necho " + png +
               " | base64 -d > \"$2\"";
    };
    script("bin/lineatlas", draw(black) + "\ncase $2 in *cpp.png) echo " + nearly_black +
                                " | base64 -d > \"$2\";; esac");
    EXPECT_EQ(run("--part picture --part 'picture cpp'"), 0);
    EXPECT_EQ(part("picture cpp")["compared"]["the device's"]["differ"], 1);
    EXPECT_NE(markdown().find("| picture cpp | the device's | 1 | 1 | 0 |"), std::string::npos);
    EXPECT_EQ(markdown().find("the bundle's"), std::string::npos) << "it has none";

    fs::create_directories(folder_ / "share/pictures");
    fs::copy(folder_ / "out-pictures/picture-device.png", folder_ / "share/pictures/picture.png");
    EXPECT_EQ(run("--part picture"), 0);
    EXPECT_NE(markdown().find("| picture | the bundle's | 1 | 0 | 0 |"), std::string::npos);
}

TEST_F(Check, LeavesOutAPictureThatWasNotDrawn) {
    fs::create_directories(folder_ / "out-pictures");
    std::ofstream{folder_ / "out-pictures/picture-device.png"} << "of an earlier run";
    script("bin/lineatlas", "exit 4");
    EXPECT_EQ(run("--part picture"), 1);
    EXPECT_EQ(markdown().find("!["), std::string::npos);
}

TEST_F(Check, EndsAPartThatHangs) {
    script("bin/lineatlas", write_figures);
    script("bin/lineatlas-bench-interop", "sleep 300 &\nwait");
    EXPECT_EQ(run("--limit 2 --part devices --part 'interop copy'"), 1);
    EXPECT_NE(std::string{part("interop copy")["outcome"]}.find("not done in 2 s"),
              std::string::npos);
    EXPECT_LT(part("interop copy")["seconds"], 20);
}

} // namespace
} // namespace lineatlas::bench
