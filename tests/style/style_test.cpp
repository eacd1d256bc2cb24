// Style files and the table of settings: accepted values, refused ones, and the words of refusals.

#include "lineatlas/style_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/style_lengths.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"
#include "style/settings.hpp"

namespace fs = std::filesystem;

namespace lineatlas {
namespace {

/// The value of every key of `style`, as TOML.
std::map<std::string, std::string> all_values(const Style& style) {
    std::map<std::string, std::string> values;
    for (const Setting& setting : settings()) {
        values[setting.key] = value_to_toml(setting.get(style));
    }
    return values;
}

/// Per key a value other than the default, as on the command line.
const std::map<std::string, std::string>& samples() {
    static const std::map<std::string, std::string> values{
        {"pen", "charcoal"},
        {"width", "3.25"},
        {"made-for", "600"},
        {"color", "#204060"},
        {"opacity", "0.75"},
        {"join", "bevel"},
        {"mitre-limit", "7"},
        {"cap", "taper"},
        {"path-cap", "texture"},
        {"cap-length", "33"},
        {"width-profile", "0.25,1,4"},
        {"opacity-profile", "0.5"},
        {"hidden", "true"},
        {"hidden-pen", "dotted"},
        {"hidden-width", "0.5"},
        {"hidden-color", "navy"},
        {"hidden-opacity", "0.125"},
        {"hidden-join", "round"},
        {"hidden-mitre-limit", "2"},
        {"hidden-cap", "round"},
        {"hidden-path-cap", "butt"},
        {"hidden-cap-length", "0"},
        {"hidden-width-profile", "2"},
        {"hidden-opacity-profile", "1,0"},
        {"fill-holes", "5"},
        {"drop-runs", "6"},
        {"overshoot", "7"},
        {"overshoot-variation", "1"},
        {"undershoot", "8"},
        {"halo", "9"},
        {"more-lines", "centre,ridge"},
        {"centre-overhang", "3"},
        {"density", "0.25"},
        {"hidden-density", "0.25"},
        {"density-priority", "0,0.25,0.5,0.75,1,0.125,1,0.5,0.25,0,1,0,0.5"},
        {"fill", "toon"},
        {"fill-color", "0.1,0.2,0.3"},
        {"light", "-1,2,0.5"},
        {"ambient", "0"},
        {"toon-steps", "5"},
        {"paper", "ivory"},
        {"paper-grain", "0.5"},
        {"focus", "1,-2.5,3"},
        {"focus-radius", "0.125"},
        {"focus-falloff", "0"},
        {"focus-width", "0.25"},
        {"focus-opacity", "0.5"},
        {"focus-hidden-opacity", "1"},
        {"focus-density", "0.5"},
        {"focus-pen", "pencil"},
    };
    return values;
}

class StyleFiles : public testing::Test {
  protected:
    void SetUp() override {
        ::unsetenv("LINEATLAS_STYLE_DIR");
        folder_ = fs::temp_directory_path() / ("lineatlas_styles_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override {
        ::unsetenv("LINEATLAS_STYLE_DIR");
        fs::remove_all(folder_);
    }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    std::string file(const std::string& name, const std::string& text) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream{path(name), std::ios::binary} << text;
        return path(name);
    }

    /// Expects that loading the text fails with a FileError whose single line holds all of `words`.
    void expect_refused(const std::string& text, const std::vector<std::string>& words) const {
        const std::string name = file("bad.toml", text);
        try {
            load_style(name);
            ADD_FAILURE() << "taken: " << text;
        } catch (const FileError& error) {
            const std::string message = error.what();
            EXPECT_NE(message.find(name), std::string::npos) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            for (const std::string& word : words) {
                EXPECT_NE(message.find(word), std::string::npos)
                    << '"' << word << "\" is not in: " << message;
            }
        }
    }

    fs::path folder_;
};

std::string refusal(const std::string& change) {
    Style style;
    const auto before = all_values(style);
    try {
        apply_setting(style, change);
    } catch (const UsageError& error) {
        EXPECT_EQ(all_values(style), before) << "changed by what was refused: " << change;
        return error.what();
    }
    ADD_FAILURE() << "taken: " << change;
    return {};
}

TEST(Settings, EachIsSetAndChangesNothingElse) {
    for (const Setting& setting : settings()) {
        ASSERT_TRUE(samples().contains(setting.key)) << setting.key;
        Style style;
        auto expected = all_values(style);
        apply_setting(style, setting.key + "=" + samples().at(setting.key));
        const auto values = all_values(style);
        EXPECT_NE(values.at(setting.key), expected.at(setting.key)) << setting.key;
        expected[setting.key] = values.at(setting.key);
        EXPECT_EQ(values, expected) << setting.key;
    }
    EXPECT_EQ(settings().size(), samples().size());
}

TEST(Settings, ValuesLandInTheirMembers) {
    Style style;
    for (const auto& [key, value] : samples()) apply_setting(style, key + "=" + value);
    EXPECT_EQ(style.pen.mark, "charcoal");
    EXPECT_EQ(style.pen.width, 3.25F);
    EXPECT_EQ(style.pen.color, glm::vec3(32, 64, 96) / 255.0F);
    EXPECT_EQ(style.pen.join, Join::bevel);
    EXPECT_EQ(style.pen.cap, Cap::taper);
    EXPECT_EQ(style.pen.path_cap, Cap::texture);
    EXPECT_EQ(style.pen.width_profile, (Profile{0.25F, 1, 4}));
    EXPECT_EQ(style.pen.opacity_profile, Profile{0.5F});
    EXPECT_TRUE(style.hidden);
    EXPECT_EQ(style.hidden_pen.mark, "dotted");
    EXPECT_EQ(style.hidden_pen.join, Join::round);
    EXPECT_EQ(style.filter.fill_holes, 5);
    EXPECT_EQ(style.filter.drop_runs, 6);
    EXPECT_EQ(style.filter.overshoot, 7);
    EXPECT_EQ(style.more_lines, mask_of(LineKind::centre) | mask_of(LineKind::ridge));
    EXPECT_EQ(style.centre_overhang, 3);
    EXPECT_EQ(style.filter.undershoot, 8);
    EXPECT_EQ(style.filter.halo, 9);
    EXPECT_EQ(style.density.limit, 0.25F);
    EXPECT_EQ(style.density.priority, (std::array<float, 13>{0, 0.25F, 0.5F, 0.75F, 1, 0.125F, 1,
                                                             0.5F, 0.25F, 0, 1, 0, 0.5F}));
    EXPECT_EQ(style.fill.mode, FillMode::toon);
    EXPECT_EQ(style.fill.color, glm::vec3(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(style.fill.light, glm::vec3(-1, 2, 0.5F));
    EXPECT_EQ(style.fill.toon_steps, 5);
    EXPECT_EQ(style.paper.grain, 0.5F);
    EXPECT_TRUE(style.focus.on);
    EXPECT_TRUE(style.focus.in_scene);
    EXPECT_EQ(style.focus.point, glm::dvec3(1, -2.5, 3));
    EXPECT_EQ(style.focus.mark, "pencil");
    apply_setting(style, "focus=[0.25, 0.5]");
    EXPECT_FALSE(style.focus.in_scene);
    EXPECT_EQ(style.focus.point, glm::dvec3(0.25, 0.5, 0));
    apply_setting(style, "focus=none");
    EXPECT_FALSE(style.focus.on);
    apply_setting(style, "focus-pen=same");
    EXPECT_TRUE(style.focus.mark.empty());
    apply_setting(style, "pen=\"marks/mine.png\"");
    EXPECT_EQ(style.pen.mark, "marks/mine.png");
}

TEST(Settings, LengthsMayBeThoseOfPaper) {
    Style style;
    apply_setting(style, "width=0.5mm");
    EXPECT_FLOAT_EQ(style.pen.width, 0.5F * 96 / 25.4F);
    apply_setting(style, "halo=\"0.125in\"");
    EXPECT_EQ(style.filter.halo, 12);
    apply_setting(style, "hidden-width=3px");
    EXPECT_EQ(style.hidden_pen.width, 3);
}

TEST(Settings, LengthsGrowWithThePicture) {
    std::size_t lengths = 0;
    for (const Setting& setting : settings()) {
        SCOPED_TRACE(setting.key);
        Style style;
        style.density.limit = style.hidden_density = 3;
        const bool is_length = setting.values.find("length on paper") != std::string::npos;
        if (is_length) {
            ++lengths;
            set_value(style, setting, 6.0, setting.key);
        }
        const SettingValue before = setting.get(style);
        multiply_lengths(style, 2);
        if (is_length)
            EXPECT_EQ(setting.get(style), SettingValue{12.0});
        else if (setting.key == "density" || setting.key == "hidden-density")
            EXPECT_EQ(setting.get(style), SettingValue{1.5});
        else
            EXPECT_EQ(setting.get(style), before);
    }
    EXPECT_GT(lengths, 9U);
}

TEST(Settings, BadValuesAreRefusedWithWhatThereIs) {
    EXPECT_EQ(refusal("width=0"), "width must be a number above 0 and at most 1000 pixels, or a "
                                  "length on paper as \"0.5mm\", not 0");
    EXPECT_EQ(refusal("cap=rond"), "cap must be one of butt, round, taper, texture, not \"rond\"; "
                                   "did you mean \"round\"?");
    EXPECT_EQ(refusal("widht=2"), "there is no setting \"widht\"; did you mean \"width\"?");
    EXPECT_NE(refusal("pen=charcaol").find("\"charcoal\"?"), std::string::npos);
    EXPECT_NE(refusal("xyzxyzxyz=2").find("styles --keys"), std::string::npos);
    EXPECT_NE(refusal("width").find("key=value"), std::string::npos);
    for (const char* change : {"width=two",
                               "width=",
                               "width=1,2",
                               "width=[2]",
                               "width=\"2\"",
                               "width=0mm",
                               "width=0.5cm",
                               "width=mm",
                               "width=11in", // 1056 pixels
                               "opacity=1mm",
                               "color=[0,1,2]",
                               "color=[",
                               "color=\"",
                               "width=true",
                               "width=nan",
                               "width=inf",
                               "width=1e-60",
                               "width=1001",
                               "opacity=1.01",
                               "opacity=-0.1",
                               "mitre-limit=0.5",
                               "hidden=1",
                               "hidden=yes",
                               "color=#12345",
                               "color=#12345g",
                               "color=#1234567",
                               "color=blurple",
                               "color=1,2,3",
                               "color=0.5",
                               "color=0,0",
                               "width-profile=5",
                               "width-profile=1,1,x",
                               "opacity-profile=1,1.5",
                               "width-profile=1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1",
                               "density-priority=1,1,1,1,1",
                               "density-priority=1,1,1,1,1,1,1,1,1,1,1,1,2",
                               "light=0,0,0",
                               "light=1,2",
                               "light=nan,0,1",
                               "toon-steps=1",
                               "toon-steps=2.5",
                               "toon-steps=9",
                               "focus=here",
                               "focus=0.5",
                               "focus=1,2,3,4",
                               "focus=nan,1",
                               "focus-pen=crayon",
                               "pen=same",
                               "pen=",
                               "fill=phong",
                               "halo=-1",
                               "=2",
                               ""}) {
        EXPECT_FALSE(refusal(change).empty()) << change;
    }
}

/// A value of a member that a program can set but no style file can.
struct Misuse {
    std::string key;
    std::function<void(Style&)> set;
};

std::vector<Misuse> misuses() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float endless = std::numeric_limits<float>::infinity();
    std::vector<Misuse> all;
    const auto add = [&](const std::string& key, auto member, auto... wrong) {
        const auto one = [&](auto value) {
            all.push_back({key, [member, value](Style& style) { member(style) = value; }});
        };
        (one(wrong), ...);
    };
    const auto add_number = [&](const std::string& key, auto member, float below, float above) {
        add(key, member, below, above, nan, endless, -endless);
    };
    const auto add_color = [&](const std::string& key, auto member) {
        add(key, member, glm::vec3{2, 0, 0}, glm::vec3{0, 0, -1}, glm::vec3{0, nan, 0});
    };
    const auto add_pen = [&](const std::string& prefix, const std::string& mark, auto pen) {
        const auto of = [&](auto member) {
            return [ pen, member ](Style & style) -> auto& {
                return pen(style).*member;
            };
        };
        add(mark, of(&Pen::mark), std::string{}, std::string{"crayon"});
        add_number(prefix + "width", of(&Pen::width), 0, 1001);
        add_color(prefix + "color", of(&Pen::color));
        add_number(prefix + "opacity", of(&Pen::opacity), -0.1F, 7);
        add(prefix + "join", of(&Pen::join), Join{3}, Join{-1});
        add_number(prefix + "mitre-limit", of(&Pen::mitre_limit), -3, 101);
        add(prefix + "cap", of(&Pen::cap), Cap{4});
        add(prefix + "path-cap", of(&Pen::path_cap), Cap{99});
        add_number(prefix + "cap-length", of(&Pen::cap_length), -5, 10'001);
        add(prefix + "width-profile", of(&Pen::width_profile), Profile{}, Profile(17, 1.0F),
            Profile{1, 5}, Profile{nan});
        add(prefix + "opacity-profile", of(&Pen::opacity_profile), Profile{}, Profile{-1});
    };
    add_pen("", "pen", [](Style& s) -> Pen& { return s.pen; });
    add_pen("hidden-", "hidden-pen", [](Style& s) -> Pen& { return s.hidden_pen; });
    const auto filter = [&](auto member) {
        return [member](Style& s) -> float& { return s.filter.*member; };
    };
    add_number("fill-holes", filter(&StrokeFilter::fill_holes), -1, 10'001);
    add_number("drop-runs", filter(&StrokeFilter::drop_runs), -1, 10'001);
    add_number("overshoot", filter(&StrokeFilter::overshoot), -1, 10'001);
    add_number("overshoot-variation", filter(&StrokeFilter::overshoot_variation), -1, 1.1F);
    add_number("undershoot", filter(&StrokeFilter::undershoot), -1, 10'001);
    add_number("halo", filter(&StrokeFilter::halo), -4, 10'001);
    add_number(
        "centre-overhang", [](Style& s) -> float& { return s.centre_overhang; }, -1, 10'001);
    add(
        "more-lines", [](Style& s) -> std::uint32_t& { return s.more_lines; },
        std::uint32_t{1} << 31U);
    const auto number = [&](const std::string& key, auto member, float below, float above) {
        add_number(
            key, [member](Style& s) -> float& { return member(s); }, below, above);
    };
    number(
        "density", [](Style& s) -> float& { return s.density.limit; }, -1, 101);
    number(
        "hidden-density", [](Style& s) -> float& { return s.hidden_density; }, -1, 101);
    number(
        "density-priority", [](Style& s) -> float& { return s.density.priority[12]; }, -1, 2);
    add(
        "fill", [](Style& s) -> FillMode& { return s.fill.mode; }, FillMode{4});
    add_color("fill-color", [](Style& s) -> glm::vec3& { return s.fill.color; });
    add(
        "light", [](Style& s) -> glm::vec3& { return s.fill.light; }, glm::vec3{0},
        glm::vec3{nan, 0, 1}, glm::vec3{1e7F, 0, 0});
    number(
        "ambient", [](Style& s) -> float& { return s.fill.ambient; }, -1, 2);
    add(
        "toon-steps", [](Style& s) -> int& { return s.fill.toon_steps; }, 1, 9);
    add_color("paper", [](Style& s) -> glm::vec3& { return s.paper.color; });
    number(
        "paper-grain", [](Style& s) -> float& { return s.paper.grain; }, -1, 2);
    number(
        "made-for", [](Style& s) -> float& { return s.made_for; }, 0.5F, 65537);
    add(
        "focus", [](Style& s) -> glm::dvec3& { return s.focus.point; }, glm::dvec3{nan, 0, 0});
    const auto focus = [&](auto member) {
        return [member](Style& s) -> float& { return s.focus.*member; };
    };
    add_number("focus-radius", focus(&Focus::radius), -1, 1001);
    add_number("focus-falloff", focus(&Focus::falloff), -1, 1001);
    add_number("focus-width", focus(&Focus::width), -1, 101);
    add_number("focus-opacity", focus(&Focus::opacity), -1, 2);
    add_number("focus-hidden-opacity", focus(&Focus::hidden_opacity), -1, 2);
    add_number("focus-density", focus(&Focus::density), -1, 101);
    add(
        "focus-pen", [](Style& s) -> std::string& { return s.focus.mark; }, std::string{"crayon"},
        std::string{"same"});
    return all;
}

TEST(Settings, MembersThatNoFileCanSetAreRefusedByKey) {
    std::set<std::string> keys;
    for (const auto& [key, set] : misuses()) {
        keys.insert(key);
        Style style;
        set(style);
        try {
            check_style(style);
            ADD_FAILURE() << key << ": taken";
        } catch (const UsageError& error) {
            EXPECT_EQ(std::string{error.what()}.find("style: " + key + " must be "), 0U)
                << error.what();
        }
    }
    for (const Setting& setting : settings()) {
        EXPECT_TRUE(setting.flag || keys.contains(setting.key)) << setting.key;
    }
}

TEST(Settings, WhatFilesSetIsTakenByTheCheckToo) {
    EXPECT_NO_THROW(check_style({}));
    Style style;
    for (const auto& [key, value] : samples()) {
        apply_setting(style, key + "=" + value);
        EXPECT_NO_THROW(check_style(style)) << key;
    }
    for (const StyleInfo& shipped : list_styles())
        EXPECT_NO_THROW(check_style(load_style(shipped.name))) << shipped.name;
}

TEST_F(StyleFiles, AStyleSurvivesBeingWritten) {
    Style style;
    for (const auto& [key, value] : samples()) apply_setting(style, key + "=" + value);
    for (const Style& original : {Style{}, style}) {
        const std::string name = file("written.toml", write_style(original, "Mine: \"so\" \\ \t."));
        EXPECT_EQ(all_values(load_style(name)), all_values(original));
    }
    ::setenv("LINEATLAS_STYLE_DIR", folder_.c_str(), 1);
    ASSERT_EQ(list_styles().size(), 1U);
    EXPECT_EQ(list_styles()[0].description, "Mine: \"so\" \\ \t.");
}

TEST_F(StyleFiles, EveryTypeOfTomlIsRead) {
    const Style style = load_style(file("types.toml", "width = 3\n"
                                                      "opacity = 0.5\n"
                                                      "hidden = true\n"
                                                      "color = [0, 0.5, 1]\n"
                                                      "paper = \"sepia\"\n"
                                                      "width-profile = [1, 0.5]\n"
                                                      "focus = [0.5, 0.25]\n"));
    EXPECT_EQ(style.pen.width, 3);
    EXPECT_EQ(style.pen.color, glm::vec3(0, 0.5F, 1));
    EXPECT_EQ(style.pen.width_profile, (Profile{1, 0.5F}));
    EXPECT_TRUE(style.hidden);
    EXPECT_TRUE(style.focus.on);
}

TEST_F(StyleFiles, ErrorsNameTheLineTheKeyAndTheWayOut) {
    expect_refused("# a comment\n\nwidth = 2\nwidht = 3\n", {"line 4", "\"widht\"", "\"width\"?"});
    expect_refused("width = 2\nopacity = 1.5\n", {"line 2", "opacity", "from 0 to 1", "1.5"});
    expect_refused("width = \"2\"\n", {"line 1", "width", "a number", "\"2\""});
    expect_refused("width = 9223372036854775807\n", {"line 1", "width", "a number"});
    expect_refused("width = [9223372036854775807]\n", {"line 1", "width", "a number"});
    expect_refused("\"a\\nb\" = 1\n", {"line 1", "a\\u000ab"});
    expect_refused("hidden = 1\n", {"line 1", "hidden", "true or false"});
    expect_refused("\npen = \"penci\"\n", {"line 2", "pen", "charcoal", "\"pencil\"?"});
    expect_refused("[pen]\nwidth = 2\n", {"line 1", "pen", "one of"});
    expect_refused("light = [1, \"2\", 3]\n", {"line 1", "light", "three numbers"});
    expect_refused("width = 1979-05-27\n", {"line 1", "width", "a number"});
    expect_refused("description = 3\n", {"line 1", "description"});
    expect_refused("width = 2\nwidth = 3\n", {"line 2", "width"});
    expect_refused("width = \n", {"line 1"});
    expect_refused("\x89PNG\r\n\x1a\n", {"line 1"});
    expect_refused("include = 3\n", {"line 1", "include"});
    expect_refused("\ninclude = [\"ink\",\n \"gone.toml\"]\n", {"line 3", "gone.toml", "no such"});
    expect_refused("include = \"inc\"\n", {"line 1", "\"inc\"", "\"ink\"?"});
    EXPECT_THROW(load_style(path("missing.toml")), FileError);
    EXPECT_THROW(load_style(folder_.string()), FileError);
    EXPECT_THROW(load_style("crayon"), UsageError);
    EXPECT_THROW(load_style(""), UsageError);
}

TEST_F(StyleFiles, IncludesComeFirstAndAreOverridden) {
    file("sub/base.toml", "include = \"../root.toml\"\nwidth = 5\ncolor = \"red\"\n");
    file("root.toml", "width = 9\nopacity = 0.25\nhalo = 3\n");
    file("other.toml", "halo = 4\ncolor = \"blue\"\n");
    const Style style = load_style(
        file("mine.toml",
             "width = 6\ninclude = [\"sub/base.toml\", \"./other.toml\", \"./other.toml\"]"));
    EXPECT_EQ(style.pen.width, 6) << "a file's own keys count most, before its include too";
    EXPECT_EQ(style.pen.opacity, 0.25F) << "through two files";
    EXPECT_EQ(style.pen.color, glm::vec3(0, 0, 1)) << "the later include counts more";
    EXPECT_EQ(style.filter.halo, 4);

    const Style named = load_style(file("named.toml", "include = \"blueprint\"\nwidth = 6\n"));
    EXPECT_EQ(named.pen.width, 6);
    EXPECT_EQ(named.paper.color, load_style("blueprint").paper.color);
}

TEST_F(StyleFiles, AnErrorInAnIncludedFileNamesThatFile) {
    file("part.toml", "\n\nopacity = 2\n");
    try {
        load_style(file("whole.toml", "include = \"part.toml\"\n"));
        ADD_FAILURE();
    } catch (const FileError& error) {
        EXPECT_NE(std::string{error.what()}.find("part.toml\" line 3"), std::string::npos)
            << error.what();
    }
}

TEST_F(StyleFiles, CirclesOfIncludesAreRefused) {
    expect_refused("include = \"bad.toml\"\n", {"line 1", "circle"});
    file("a.toml", "include = \"./b.toml\"\n");
    file("b.toml", "width = 1\ninclude = \"sub/../a.toml\"\n");
    fs::create_directories(folder_ / "sub");
    try {
        load_style(path("a.toml"));
        ADD_FAILURE();
    } catch (const FileError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("b.toml\" line 2"), std::string::npos) << message;
        EXPECT_NE(message.find("circle"), std::string::npos) << message;
    }
}

std::string refusal_of(const std::string& path) {
    try {
        load_style(path);
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

TEST_F(StyleFiles, IncludesHaveLimitsOfDepthAndNumber) {
    const auto link = [&](int from, int to) {
        file(std::to_string(from) + ".toml",
             to < 0 ? "width = 7\n" : "include = \"./" + std::to_string(to) + ".toml\"\n");
    };
    link(0, -1);
    for (int i = 1; i <= 1'000; ++i) link(i, i - 1);
    EXPECT_EQ(load_style(path("16.toml")).pen.width, 7);
    for (const char* first : {"17.toml", "1000.toml"}) {
        const std::string deep = refusal_of(path(first));
        EXPECT_NE(deep.find("is more than 16 levels deep"), deep.npos) << deep;
        EXPECT_EQ(deep.find('\n'), deep.npos);
    }

    const auto many = [](int times) {
        std::string text = "include = [";
        for (int i = 0; i < times; ++i) text += "\"./0.toml\",";
        return text + "]\n";
    };
    EXPECT_EQ(load_style(file("most.toml", many(100))).pen.width, 7);
    const std::string more = refusal_of(file("more.toml", many(101)));
    EXPECT_NE(more.find("more than 100 files"), more.npos) << more;
}

TEST_F(StyleFiles, ManyRepeatedIncludesAreRefused) {
    for (int i = 0; i < 10; ++i) {
        std::string text = "include = [";
        for (int k = 0; i < 9 && k < 10; ++k) text += "\"./" + std::to_string(i + 1) + ".toml\",";
        file(std::to_string(i) + ".toml", text + "]\n");
    }
    const std::string message = refusal_of(path("0.toml"));
    EXPECT_NE(message.find("more than 100 files"), message.npos) << message;
}

TEST_F(StyleFiles, AFileThatTheSystemMakesUpIsReadNoFurtherThanItsSize) {
    // The size of this file is 0, but it can be read.
    EXPECT_EQ(write_style(load_style("/proc/self/limits"), ""),
              write_style(load_style(file("empty.toml", "")), ""));
}

TEST_F(StyleFiles, PicturesOfPensStandBesideTheFile) {
    const Style style = load_style(file("sub/mine.toml", "pen = \"marks/chalk.png\"\n"
                                                         "hidden-pen = \"/abs/a.png\"\n"));
    EXPECT_EQ(style.pen.mark, path("sub/marks/chalk.png"));
    EXPECT_EQ(style.hidden_pen.mark, "/abs/a.png");
}

TEST_F(StyleFiles, PensByRule) {
    const Style style = load_style(file("mine.toml", "include = \"plain\"\n"
                                                     "width = 3\n"
                                                     "[[pens]]\n"
                                                     "match = { kind = \"outline\" }\n"
                                                     "width = 4\n"
                                                     "pen = \"chalk.png\"\n"
                                                     "[[pens]]\n"
                                                     "match = { object = \"Bolt*\", "
                                                     "material = \"steel\" }\n"
                                                     "color = \"navy\"\n"
                                                     "[[pens]]\n"
                                                     "match = { kind = \"crease\", "
                                                     "hidden = true }\n"
                                                     "width-factor = 2\n"));
    const std::size_t plain = default_style().pens.size();
    EXPECT_GT(plain, 0U);
    ASSERT_EQ(style.pens.size(), plain + 3);
    const PenRule& outline = style.pens[plain];
    EXPECT_EQ(outline.match.kinds, std::vector<std::string>{"outline"});
    EXPECT_EQ(outline.width, 4.0F);
    EXPECT_EQ(outline.mark, path("chalk.png"));
    EXPECT_FALSE(outline.color);
    EXPECT_EQ(style.pens[plain + 1].match.object, "Bolt*");
    EXPECT_EQ(style.pens[plain + 1].match.material, "steel");
    EXPECT_FALSE(style.pens[plain + 1].match.hidden);
    EXPECT_TRUE(style.pens[plain + 2].match.hidden);
    const std::string text = write_style(style);
    EXPECT_EQ(write_style(load_style(file("again.toml", text))), text);
    // An empty list removes the pens of the included style.
    EXPECT_TRUE(load_style(file("none.toml", "include = \"plain\"\npens = []\n")).pens.empty());
}

TEST_F(StyleFiles, RulesThatAreRefused) {
    expect_refused("[[pens]]\nmatch = { kind = \"outlin\" }\n", {"line 2", "\"outline\"?"});
    expect_refused("[[pens]]\nmatch = { kind = \"xyzxyz\" }\n", {"line 2", "there is crease"});
    expect_refused("[[pens]]\nmatch = { part = \"a\" }\n",
                   {"line 2", "kind, object, material, hidden"});
    expect_refused("[[pens]]\nmatch = { object = \"\" }\n", {"line 2", "object must be a name"});
    expect_refused("[[pens]]\nmatch = \"outline\"\n", {"line 2", "match must be a table"});
    expect_refused("[[pens]]\nmatch = { kind = 3 }\n", {"line 2", "kind must be a text"});
    expect_refused("[[pens]]\nmatch = { kind = true }\n", {"line 2", "kind must be a text"});
    expect_refused("[[pens]]\nmatch = { hidden = \"yes\" }\n",
                   {"line 2", "hidden must be true or false"});
    expect_refused("[[pens]]\nmatch = { hidden = true, kind = \"outline\" }\n",
                   {"line 2", "hidden lines have no outline"});
    expect_refused("[[pens]]\nwidht = 3\n", {"line 2", "\"widht\"", "\"width\"?"});
    expect_refused("[[pens]]\nhalo = 3\n", {"line 2", "\"halo\"", "width-factor"});
    expect_refused("[[pens]]\nwidth = 0\n", {"line 2", "above 0"});
    expect_refused("[[pens]]\nwidth-factor = 1000\n", {"line 2", "from 0.01 to 100"});
    expect_refused("pens = 3\n", {"line 1", "[[pens]]"});
    expect_refused("pens = [3]\n", {"line 1", "[[pens]]"});
}

TEST_F(StyleFiles, TheStylesThatShip) {
    std::vector<std::string> names;
    for (const StyleInfo& style : list_styles()) {
        names.push_back(style.name);
        EXPECT_FALSE(style.description.empty()) << style.name;
        EXPECT_NE(all_values(load_style(style.name)), all_values(Style{})) << style.name;
    }
    EXPECT_EQ(names, (std::vector<std::string>{"blueprint", "charcoal", "haloed", "ink", "pencil",
                                               "plain", "technical"}));
    // The styles are the same when they are read from their files.
    const fs::path folder = fs::path{LINEATLAS_SOURCE_DIR} / "styles";
    for (const std::string& name : names) {
        EXPECT_EQ(all_values(load_style((folder / (name + ".toml")).string())),
                  all_values(load_style(name)));
    }
}

TEST_F(StyleFiles, AFolderTakesThePlaceOfTheStylesThatShip) {
    file("mine.toml", "description = \"My own\"\nwidth = 7\n");
    file("notes.txt", "no style");
    ::setenv("LINEATLAS_STYLE_DIR", folder_.c_str(), 1);
    ASSERT_EQ(list_styles().size(), 1U);
    EXPECT_EQ(list_styles()[0].name, "mine");
    EXPECT_EQ(load_style("mine").pen.width, 7);
    EXPECT_THROW(load_style("pencil"), UsageError);
    ::setenv("LINEATLAS_STYLE_DIR", path("gone").c_str(), 1);
    EXPECT_THROW(list_styles(), FileError);
}

/// The page must hold the output of `lineatlas styles --keys`.
TEST(Settings, TheUsersPageHasTheTable) {
    std::ifstream file{fs::path{LINEATLAS_SOURCE_DIR} / "docs/styles.md"};
    std::ostringstream page;
    page << file.rdbuf();
    EXPECT_TRUE(page.str().find(settings_table()) != std::string::npos)
        << "docs/styles.md does not hold this table:\n"
        << settings_table();
    for (const StyleInfo& style : list_styles()) {
        EXPECT_NE(page.str().find("| `" + style.name + "` | " + style.description + " |"),
                  std::string::npos)
            << style.name;
    }
}

} // namespace
} // namespace lineatlas
