// The table of frame settings: accepted values, refused ones, and values that follow from the
// quality.

#include "style/frame_settings.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

namespace lineatlas {
namespace {

/// Per key a value other than the default, as on the command line.
const std::map<std::string, std::string> samples{{"lines", "crease,silhouette"},
                                                 {"method", "item-buffer"},
                                                 {"quality", "low"},
                                                 {"probes", "16"},
                                                 {"depth-scale", "3"},
                                                 {"step", "0.5"},
                                                 {"atlas", "compute"},
                                                 {"depth", "raster"},
                                                 {"strokes", "compute"}};

std::map<std::string, SettingValue> all_values(const FrameSettings& settings) {
    std::map<std::string, SettingValue> values;
    for (const FrameSetting& setting : frame_settings()) {
        values[setting.key] = setting.get(settings);
    }
    return values;
}

FrameSettings with(const std::map<std::string, std::string>& changes) {
    FrameSettings settings;
    for (const auto& [key, value] : changes) {
        set_value(settings, find_frame_setting(key), value_from_text(value), "--" + key);
    }
    return settings;
}

TEST(FrameSettings, EachIsSetAndChangesNothingElse) {
    ASSERT_EQ(samples.size(), frame_settings().size());
    const auto before = all_values({});
    for (const auto& [key, text] : samples) {
        auto after = all_values(with({{key, text}}));
        EXPECT_EQ(after.at(key), value_from_text(text)) << key;
        if (key == "quality") after["probes"] = before.at("probes");
        if (key == "quality") after["depth-scale"] = before.at("depth-scale");
        after[key] = before.at(key);
        EXPECT_EQ(after, before) << key;
    }
}

TEST(FrameSettings, ValuesLandInTheirMembers) {
    const FrameOptions options = with(samples).for_pixels();
    EXPECT_EQ(options.lines, mask_of(LineKind::crease) | mask_of(LineKind::silhouette));
    EXPECT_EQ(options.method, Method::item_buffer);
    EXPECT_EQ(options.probes, 16U);
    EXPECT_EQ(options.depth_scale, 3);
    EXPECT_EQ(options.step, 0.5F);
    EXPECT_EQ(options.forms.atlas, StageForm::compute);
    EXPECT_EQ(options.forms.depth, StageForm::raster);
    EXPECT_EQ(options.forms.strokes, StageForm::compute);
}

TEST(FrameSettings, NamesStandInTheOrderOfTheEnumerators) {
    EXPECT_EQ(name_of(Method::atlas), "atlas");
    EXPECT_EQ(name_of(Method::exact), "exact");
    EXPECT_EQ(name_of(Method::spine), "spine");
    EXPECT_EQ(name_of(Method::item_buffer), "item-buffer");
    EXPECT_EQ(name_of(Method::opengl), "opengl");
    EXPECT_EQ(with({{"atlas", "raster"}}).rest.forms.atlas, StageForm::raster);
    EXPECT_EQ(with({{"atlas", "auto"}}).rest.forms.atlas, StageForm::automatic);
}

TEST(FrameSettings, DefaultsAreThoseOfFrameOptions) {
    const FrameOptions options = FrameSettings{}.for_pixels(), usual;
    EXPECT_EQ(options.probes, usual.probes);
    EXPECT_EQ(options.depth_scale, usual.depth_scale);
}

TEST(FrameSettings, TheMethodIsExactButForSequencesAndWhereSamplesAreAskedFor) {
    const FrameSettings plain;
    EXPECT_EQ(plain.for_pixels().method, Method::exact);
    EXPECT_EQ(plain.for_paths({100, 100}).method, Method::exact);
    EXPECT_EQ(plain.for_sequence().method, Method::atlas);
    for (const auto& [key, value] : samples) {
        if (key == "method") continue;
        const bool of_samples = key != "lines" && key != "strokes";
        const Method expected = of_samples ? Method::atlas : Method::exact;
        const FrameSettings changed = with({{key, value}});
        EXPECT_EQ(changed.for_pixels().method, expected) << key;
        EXPECT_EQ(changed.for_paths({100, 100}).method, expected) << key;
        EXPECT_EQ(changed.for_sequence().method, Method::atlas) << key;
    }
    for (const char* name : {"atlas", "exact", "spine"}) {
        const FrameSettings said = with({{"method", name}, {"probes", "4"}});
        EXPECT_EQ(name_of(said.for_pixels().method), name);
        EXPECT_EQ(name_of(said.for_sequence().method), name);
    }
    EXPECT_FALSE(with({{"method", "auto"}}).method.has_value());
}

TEST(FrameSettings, GivenNumbersOverruleTheQuality) {
    const FrameOptions low = with({{"quality", "low"}}).for_pixels();
    EXPECT_EQ(low.probes, 1U);
    EXPECT_EQ(low.depth_scale, 1);
    const FrameOptions said = with({{"quality", "low"}, {"probes", "4"}}).for_pixels();
    EXPECT_EQ(said.probes, 4U);
    EXPECT_EQ(said.depth_scale, 1);
    EXPECT_EQ(with({{"depth-scale", "3"}}).for_pixels().probes, 9U);
}

TEST(FrameSettings, PathsGetAFinerDepthBufferWhereGlHasRoomForIt) {
    const FrameSettings high, low = with({{"quality", "low"}});
    EXPECT_EQ(high.for_paths({4096, 4096}).depth_scale, 4);
    EXPECT_EQ(high.for_paths({4097, 10}).depth_scale, 2);
    EXPECT_EQ(high.for_paths({10, 4097}).depth_scale, 2);
    EXPECT_EQ(low.for_paths({100, 100}).depth_scale, 1);
    EXPECT_EQ(with({{"depth-scale", "3"}}).for_paths({100, 100}).depth_scale, 3);
    EXPECT_EQ(high.for_paths({100, 100}).probes, 9U);
}

TEST(FrameSettings, BadValuesAreRefusedWithWhatThereIs) {
    const auto refusal = [](const std::string& key, const std::string& text) -> std::string {
        try {
            with({{key, text}});
        } catch (const UsageError& error) {
            return error.what();
        }
        return key + " took " + text;
    };
    EXPECT_EQ(refusal("method", "opengel"), "--method must be one of auto, atlas, exact, spine, "
                                            "item-buffer, opengl, not \"opengel\"; did "
                                            "you mean \"opengl\"?");
    EXPECT_EQ(refusal("probes", "5"), "--probes must be one of 1, 4, 9, 16, not 5");
    for (const char* text : {"0", "5", "2.5", "-1", "1e300", "two", "2,2", "true"}) {
        EXPECT_NE(refusal("depth-scale", text).find("a whole number from 1 to 4"),
                  std::string::npos);
        EXPECT_NE(refusal("probes", text).find("one of 1, 4, 9, 16"), std::string::npos);
    }
    for (const char* text : {"0", "-2", "nan", "inf", "1e300", "0.009", "x"}) {
        EXPECT_NE(refusal("step", text).find("from 0.01 to 10000 pixels"), std::string::npos);
    }
    for (const char* text : {"", "creases", "crease,", ",crease", "crease,,file", "1"}) {
        EXPECT_NE(refusal("lines", text).find("crease, boundary, material"), std::string::npos);
    }
    EXPECT_THROW(find_frame_setting("probe"), UsageError);
}

TEST(FrameSettings, TheUsersPageHasTheTable) {
    std::ifstream file{std::filesystem::path{LINEATLAS_SOURCE_DIR} / "docs/output.md"};
    std::ostringstream page;
    page << file.rdbuf();
    EXPECT_NE(page.str().find(frame_settings_table()), std::string::npos)
        << "docs/output.md does not hold this table:\n"
        << frame_settings_table();
}

} // namespace
} // namespace lineatlas
