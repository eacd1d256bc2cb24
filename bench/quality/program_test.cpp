// The whole program on scenes: its figures are good, and they get bad if visibility is wrong.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream{path}.rdbuf();
    return text.str();
}

class QualityProgram : public testing::Test {
  protected:
    static void TearDownTestSuite() { fs::remove_all(folder_); }
    void SetUp() override { fs::create_directories(folder_ / "cache"); }
    void TearDown() override {
        for (const auto& entry : fs::directory_iterator{folder_}) {
            if (entry.path() != folder_ / "cache") fs::remove_all(entry.path());
        }
    }

    nlohmann::json measure(const std::string& environment, const std::string& arguments) const {
        const fs::path json = folder_ / "figures.json";
        const std::string command =
            "POCL_CACHE_DIR=${POCL_CACHE_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/pocl/kcache} "
            "XDG_CACHE_HOME=" +
            (folder_ / "cache").string() + " LINEATLAS_CACHE=on " + environment +
            " " LINEATLAS_BENCH_QUALITY " --json " + json.string() + " " + arguments +
            " >/dev/null 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
        return nlohmann::json::parse(content(json));
    }

    /// A copy of a folder of sources with one text replaced, which occurs there exactly once.
    fs::path with_planted(const std::string& name, const std::string& from,
                          const std::string& to) const {
        fs::remove_all(folder_ / name);
        fs::create_directories(folder_);
        fs::copy(fs::path{LINEATLAS_SOURCE_DIR} / name, folder_ / name,
                 fs::copy_options::recursive);
        int planted = 0;
        for (const auto& entry : fs::recursive_directory_iterator{folder_ / name}) {
            if (!entry.is_regular_file()) continue;
            std::string text = content(entry.path());
            if (const auto at = text.find(from); at != std::string::npos) {
                text.replace(at, from.size(), to);
                ++planted;
            }
            std::ofstream{entry.path()} << text;
        }
        EXPECT_EQ(planted, 1) << from;
        return folder_ / name;
    }

    /// Holds `cache` with programs and truths for all tests of this process. Truths of other
    /// versions must not be used. PoCL keeps its usual cache.
    inline static const fs::path folder_ =
        fs::path{testing::TempDir()} / ("lineatlas-quality-" + std::to_string(getpid()));
};

TEST_F(QualityProgram, MeasuresEveryMethod) {
    const nlohmann::json methods =
        measure("", "--scene clevis --at 0.3")["scenes"]["clevis"]["methods"];
    for (const char* name : {"IBlo", "IBhi", "STlo", "SThi", "SAlo", "SAhi"}) {
        ASSERT_TRUE(methods.contains(name)) << name;
        for (const char* figure :
             {"mean_error", "wrong", "false_visible", "false_hidden", "sparkle", "crawl"}) {
            EXPECT_TRUE(methods[name].at(figure).is_number()) << name << ", " << figure;
        }
        EXPECT_LT(methods[name]["mean_error"], 0.05) << name;
    }
    EXPECT_LT(methods["SAhi"]["mean_error"], 0.5 * methods["IBlo"]["mean_error"].get<double>());
}

TEST_F(QualityProgram, OrthographicViewsAreAsTrue) {
    const std::string orthographic = "--scene clevis --projection orthographic ";
    const nlohmann::json samples =
        measure("", orthographic + "--at 0.3 --burst 1 --methods SAhi,SThi")["scenes"]["clevis"];
    for (const char* name : {"SAhi", "SThi"}) {
        EXPECT_LT(samples["methods"][name]["mean_error"], 0.005) << name;
        EXPECT_LT(samples["methods"][name]["wrong"], 0.0005) << name;
    }
    const nlohmann::json paths = measure("", orthographic + "--paths")["paths"];
    ASSERT_EQ(paths.size(), 2U);
    for (const char* view : {"clevis, isometric", "clevis, front"}) {
        for (const char* method : {"SAhi", "EX"}) {
            const nlohmann::json& f = paths[view][method];
            EXPECT_GT(f["visible"], 9000) << view << ", " << method;
            EXPECT_LT(f["missed"], 0.0005) << view << ", " << method;
            EXPECT_LT(f["false"], 0.0001) << view << ", " << method;
            EXPECT_LT(f["missed_ink"], 0.0002) << view << ", " << method;
            EXPECT_LT(f["false_ink"], 0.001) << view << ", " << method;
        }
        EXPECT_LT(paths[view]["EX"]["strict_hidden"], 0.0001) << view;
    }
}

TEST_F(QualityProgram, FindsAPlantedTolerance) {
    // With such a rounding every face touches the line, so no line is hidden.
    const fs::path kernels = with_planted("kernels", "#define LA_NEARNESS_ROUNDING 4.8e-7f",
                                          "#define LA_NEARNESS_ROUNDING 1e9f");
    const std::string arguments = "--scene clevis --at 0.3 --burst 1 --methods SAhi,SThi";
    const nlohmann::json good = measure("", arguments);
    const nlohmann::json bad = measure("LINEATLAS_KERNEL_DIR=" + kernels.string(), arguments);
    for (const char* name : {"SAhi", "SThi"}) {
        EXPECT_LT(good["scenes"]["clevis"]["methods"][name]["wrong"], 0.003) << name;
        EXPECT_GT(bad["scenes"]["clevis"]["methods"][name]["false_visible"], 0.1) << name;
        EXPECT_EQ(bad["scenes"]["clevis"]["methods"][name]["false_hidden"], 0) << name;
    }
}

/// The figures of SAhi that are worse than their known values. docs/quality.md wants a mean error
/// of 0.02, 0.3 % wrong samples and 0.2 % of either kind. All scenes reach that but the house,
/// whose mean error is 0.024 in pictures as small as these.
std::vector<std::string> misses(const nlohmann::json& figures) {
    struct Known {
        double mean_error, false_visible, false_hidden;
    };
    const std::map<std::string, Known> known{{"clevis", {0.0065, 0.0004, 0.0004}},
                                             {"house", {0.0252, 0.0009, 0.0005}},
                                             {"ship", {0.0082, 0.0007, 0.0003}},
                                             {"office", {0.0058, 0.0005, 0.0003}}};
    std::vector<std::string> result;
    for (const auto& [name, scene] : figures["scenes"].items()) {
        const auto& f = scene["methods"]["SAhi"];
        const auto limit = [&](const char* figure, double most) {
            const double value = f.at(figure);
            if (value > most) result.push_back(name + ", " + figure + ": " + std::to_string(value));
        };
        limit("mean_error", known.at(name).mean_error);
        limit("false_visible", known.at(name).false_visible);
        limit("false_hidden", known.at(name).false_hidden);
    }
    return result;
}

TEST_F(QualityProgram, ScenesAreAsTheyAreKnownToBe) {
    const std::string arguments = "--at 0.3 --burst 1 --size 512x384 --methods SAhi";
    const nlohmann::json good = measure("", arguments);
    EXPECT_EQ(good["scenes"].size(), 4U);
    EXPECT_EQ(misses(good), std::vector<std::string>{});
    // Three planted errors: surfaces far before a line do not hide it; no smooth patch is known;
    // planes are taken at the centre of the texel, not at the probe.
    struct Planted {
        const char *from, *to, *figure;
    };
    const std::vector<Planted> errors{
        {"!(before > contact)", "!(before > contact + 10.0f * depths.bend * inverse_w)",
         "false_visible"},
        {"own == spine.patch_a || own == spine.patch_b",
         "own == spine.patch_a + 1 || own == spine.patch_b + 1", "false_hidden"},
        {"plane_x * (side_x * depths.screen_scale.x) + plane_y * (side_y * depths.screen_scale.y)",
         "plane_x * ((TO_FLOAT(column) + 0.5f - x) * depths.screen_scale.x) + "
         "plane_y * ((TO_FLOAT(row) + 0.5f - y) * depths.screen_scale.y)",
         "mean_error"}};
    for (const Planted& error : errors) {
        const fs::path kernels = with_planted("kernels", error.from, error.to);
        const std::vector<std::string> worse = misses(
            measure("LINEATLAS_KERNEL_DIR=" + kernels.string(), arguments + " --scene house"));
        EXPECT_TRUE(std::ranges::any_of(worse, [&](const std::string& miss) {
            return miss.starts_with(std::string{"house, "} + error.figure);
        })) << error.to;
    }
}

TEST_F(QualityProgram, MeasuresDrawingsAsPathsAndPixels) {
    const std::string arguments = "--scene clevis --paths";
    const nlohmann::json good = measure("", arguments)["paths"];
    ASSERT_EQ(good.size(), 2U);
    for (const char* view : {"clevis, outside", "clevis, inside"}) {
        for (const char* method : {"SAhi", "EX"}) {
            const nlohmann::json& f = good[view][method];
            EXPECT_GT(f["visible"], 9000) << view << ", " << method;
            EXPECT_LT(f["missed"], 0.0005) << view << ", " << method;
            EXPECT_LT(f["false"], 0.0001) << view << ", " << method;
            EXPECT_LT(f["strict_hidden"], 0.003) << view << ", " << method;
            EXPECT_LT(f["missed_ink"], 0.0002) << view << ", " << method;
            EXPECT_LT(f["false_ink"], 0.001) << view << ", " << method;
        }
    }
    // With such a rounding every face touches the line, so no line is hidden.
    const fs::path kernels = with_planted("kernels", "#define LA_NEARNESS_ROUNDING 4.8e-7f",
                                          "#define LA_NEARNESS_ROUNDING 1e9f");
    const nlohmann::json bad =
        measure("LINEATLAS_KERNEL_DIR=" + kernels.string(), arguments + " --methods SAhi")["paths"];
    for (const char* view : {"clevis, outside", "clevis, inside"}) {
        const nlohmann::json& f = bad[view]["SAhi"];
        EXPECT_GT(f["false"], 0.1) << view;
        EXPECT_GT(f["strict_hidden"], 0.1) << view;
        EXPECT_GT(f["surely_wrong_pixels"], 1000) << view;
        EXPECT_GT(f["false_ink"], 0.1) << view;
    }
}

TEST_F(QualityProgram, ExactDrawingsHideWhatIsLessThanTwoPixelsBehind) {
    const std::string arguments = "--scene house --paths --methods EX --size 512x384";
    const nlohmann::json good = measure("", arguments)["paths"];
    // Planted: lines less than two pixels behind a face are visible.
    const fs::path kernels =
        with_planted("kernels", "behind_p - args->contact, behind_q - args->contact,",
                     "behind_p - 2.0f / (line->nearness_p * 700.0f), "
                     "behind_q - 2.0f / (line->nearness_p * 700.0f),");
    const nlohmann::json bad =
        measure("LINEATLAS_KERNEL_DIR=" + kernels.string(), arguments)["paths"];
    for (const char* view : {"house, outside", "house, inside"}) {
        EXPECT_LT(good[view]["EX"]["missed"], 0.0005) << view;
        EXPECT_LT(good[view]["EX"]["false"], 0.0001) << view;
        EXPECT_LT(good[view]["EX"]["strict_hidden"], 0.003) << view;
        EXPECT_LT(good[view]["EX"]["surely_wrong_pixels"], 2) << view;
    }
    EXPECT_GT(bad["house, outside"]["EX"]["strict_hidden"], 0.003);
}

TEST_F(QualityProgram, MeasuresWithAndWithoutTheAverageOverFrames) {
    const auto sparkle = [&](const std::string& more) -> double {
        const nlohmann::json figures = measure("", "--scene clevis --at 0.3 --methods SAhi" + more);
        return figures["scenes"]["clevis"]["methods"]["SAhi"]["sparkle"];
    };
    EXPECT_LT(sparkle(""), 0.7 * sparkle(" --no-average"));
}

TEST_F(QualityProgram, EffectsHardlySparkleMoreThanPlainLines) {
    const auto figures = [&](const std::string& environment) -> nlohmann::json {
        return measure(environment, "--scene house --at 0.3 --size 512x384 --burst 6 "
                                    "--styles overshoot,all")["scenes"]["house"]["styles"];
    };
    const nlohmann::json good = figures("");
    const double plain = good["plain"]["flicker"];
    EXPECT_GT(plain, 0);
    EXPECT_LE(good["all"]["flicker"], 1.3 * plain);
    // Planted: the overshoot changes with every frame.
    const fs::path kernels =
        with_planted("kernels", "path_share(frame.segments[work->first].path)",
                     "path_share(frame.arcs[work->last + 1] + frame.arcs[work->last])");
    const nlohmann::json bad = figures("LINEATLAS_KERNEL_DIR=" + kernels.string());
    EXPECT_EQ(bad["plain"]["flicker"], plain);
    EXPECT_GT(bad["overshoot"]["flicker"], 1.5 * good["overshoot"]["flicker"].get<double>());
}

TEST_F(QualityProgram, TellsModelsWithTheSameFileNameApart) {
    std::string arguments = "--at 0 --burst 1 --methods SAlo";
    for (const char* name : {"a", "b"}) {
        fs::create_directories(folder_ / name);
        std::ofstream{folder_ / name / "model.obj"}
            << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
        arguments += " --model " + (folder_ / name / "model.obj").string();
    }
    const nlohmann::json scenes = measure("", arguments)["scenes"];
    EXPECT_EQ(scenes.size(), 2U);
    EXPECT_TRUE(scenes.contains((folder_ / "a" / "model.obj").string()));
}

TEST_F(QualityProgram, OracleHardlyHangsOnItsRays) {
    const nlohmann::json oracle =
        measure("", "--scene clevis --at 0.3 --check-oracle")["oracle"]["clevis"];
    EXPECT_NEAR(oracle["mean_alpha"], oracle["mean_alpha_twice"], 0.002);
}

TEST_F(QualityProgram, StudyCoversEverySetting) {
    const nlohmann::json study = measure("", "--scene clevis --at 0.3 --study")["study"]["clevis"];
    ASSERT_EQ(study.size(), 16U);
    EXPECT_LT(study.back()["mean_error"], study.front()["mean_error"]);
}

} // namespace
