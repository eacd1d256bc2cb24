// The content of picture files, read with OpenImageIO: bits, alpha, notes.

#include <cmath>

#include <OpenImageIO/imageio.h>

#include "environment_variable.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

struct Stored {
    OIIO::ImageSpec spec;
    std::vector<float> values; ///< as stored, neither divided nor multiplied by alpha
};

class PictureFiles : public Tool {
  protected:
    Stored draw(const std::string& name, const std::string& options) {
        const Result result =
            run("draw --scene clevis --size 120x90 -o " + path(name) + " " + options);
        EXPECT_EQ(result.exit_code, 0) << options << "\n" << result.output;
        OIIO::ImageSpec as_stored;
        as_stored.attribute("oiio:UnassociatedAlpha", 1);
        const auto input = OIIO::ImageInput::open(path(name), &as_stored);
        if (!input) return {};
        Stored stored{input->spec(), {}};
        stored.values.resize(stored.spec.image_pixels() *
                             static_cast<std::size_t>(stored.spec.nchannels));
        EXPECT_TRUE(input->read_image(0, 0, 0, stored.spec.nchannels, OIIO::TypeDesc::FLOAT,
                                      stored.values.data()));
        return stored;
    }
};

TEST_F(PictureFiles, HaveTheBitsAskedFor) {
    using OIIO::TypeDesc;
    const std::tuple<const char*, const char*, TypeDesc::BASETYPE> cases[] = {
        {"a.png", "", TypeDesc::UINT8},           {"a.png", "--bits 8", TypeDesc::UINT8},
        {"a.png", "--bits 16", TypeDesc::UINT16}, {"a.tif", "", TypeDesc::UINT8},
        {"a.tif", "--bits 16", TypeDesc::UINT16}, {"a.exr", "", TypeDesc::HALF},
        {"a.exr", "--bits 16", TypeDesc::HALF},   {"a.exr", "--bits 32", TypeDesc::FLOAT},
        {"a.jpg", "--bits 8", TypeDesc::UINT8}};
    for (const auto& [name, options, type] : cases) {
        EXPECT_EQ(draw(name, options).spec.format, TypeDesc(type)) << name << " " << options;
    }
}

TEST_F(PictureFiles, SixteenBitsAreMoreThanEight) {
    const auto between_bytes = [](const Stored& stored) {
        return std::ranges::count_if(stored.values, [](float value) {
            return std::abs(value * 255 - std::round(value * 255)) > 0.01F;
        });
    };
    EXPECT_EQ(between_bytes(draw("a.png", "--bits 8")), 0);
    EXPECT_GT(between_bytes(draw("a.png", "--bits 16")), 300);
    EXPECT_GT(between_bytes(draw("a.tif", "--bits 16")), 300);
}

TEST_F(PictureFiles, SayWhatMadeThemAndForWhichPaper) {
    for (const char* name : {"a.png", "a.tif", "a.exr", "a.jpg"}) {
        const OIIO::ImageSpec spec = draw(name, "--dpi 300 --width 3 --pen pencil").spec;
        EXPECT_NEAR(spec.get_float_attribute("XResolution"), 300, 0.1F) << name;
        const std::string unit{spec.get_string_attribute("ResolutionUnit")};
        EXPECT_TRUE(unit == "in" || unit == "inch") << name << ": " << unit;
        const std::string software{spec.get_string_attribute("Software")};
        EXPECT_TRUE(software.starts_with("lineatlas ")) << name << ": " << software;
        const std::string description{spec.get_string_attribute("ImageDescription")};
        EXPECT_TRUE(description.starts_with("draw --scene=clevis --size=120x90 ")) << description;
        for (const char* part :
             {" --width=3", " --pen=pencil", " --dpi=300", " --eye ", " --fov "}) {
            EXPECT_NE(description.find(part), std::string::npos) << name << ": " << description;
        }
        EXPECT_EQ(description.find('\n'), std::string::npos);
        EXPECT_EQ(description.find(folder_.string()), std::string::npos) << "no paths";
    }
}

TEST_F(PictureFiles, TheirDescriptionDrawsThemAgain) {
    const Stored first = draw("a.png", "--at 0.4 --width 3 --style haloed");
    std::string again{first.spec.get_string_attribute("ImageDescription")};
    const Result result = run(again + " -o " + path("b.png"));
    EXPECT_EQ(result.exit_code, 0) << again << "\n" << result.output;
    const Stored second = draw("c.png", "--at 0.4 --width 3"); // for comparison: another style
    const auto input = OIIO::ImageInput::open(path("b.png"));
    std::vector<float> values(first.values.size());
    input->read_image(0, 0, 0, 4, OIIO::TypeDesc::FLOAT, values.data());
    const auto differing = [&](const std::vector<float>& others) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (std::abs(first.values[i] - others[i]) > 0.02F) ++count;
        }
        return count;
    };
    EXPECT_LT(differing(values), values.size() / 200);
    EXPECT_GT(differing(second.values), values.size() / 20);
}

TEST_F(PictureFiles, TransparentOnesHaveAlphaAsTheirTypeWantsIt) {
    const std::string options = "--transparent --color 0.8,0.4,0.2";
    for (const char* name : {"a.png", "a.tif", "b.png", "a.exr"}) {
        const bool linear = std::string{name} == "a.exr";
        const Stored stored = draw(name, options + (name[0] == 'b' ? " --bits 16" : ""));
        ASSERT_EQ(stored.spec.nchannels, 4) << name;
        if (std::string{name} == "a.tif") {
            EXPECT_EQ(stored.spec.get_int_attribute("oiio:UnassociatedAlpha"), 1);
        }
        std::size_t clear = 0, between = 0, full = 0;
        for (std::size_t i = 0; i < stored.values.size(); i += 4) {
            const float* p = &stored.values[i];
            const float alpha = p[3];
            (alpha == 0 ? clear : alpha > 0.999F ? full : between) += 1;
            if (alpha < 0.1F) continue;
            for (int c = 0; c < 3; ++c) {
                const float color = std::array{0.8F, 0.4F, 0.2F}[static_cast<std::size_t>(c)];
                const float expected =
                    linear ? std::pow((color + 0.055F) / 1.055F, 2.4F) * alpha : color;
                ASSERT_NEAR(p[c], expected, 0.004F) << name << " alpha " << alpha;
            }
        }
        EXPECT_GT(clear, 3000U) << name;
        EXPECT_GT(between, 200U) << name;
        EXPECT_GT(full, 50U) << name;
    }
}

TEST_F(PictureFiles, RefuseWhatTheirTypeCannotHold) {
    const std::string draw = "draw --scene clevis --size 32x24 -o ";
    expect_refused(draw + path("a.jpg") + " --transparent", 1,
                   "transparency in .jpg files is not supported; use .png, .tif or .exr");
    expect_refused(draw + path("a.bmp") + " --transparent", 1, "use .png, .tif or .exr");
    expect_refused(draw + path("a.JPEG") + " --bits 16", 1, ".JPEG files with 16 bits");
    expect_refused(draw + path("a.png") + " --bits 32", 1, ".exr has 16 or 32");
    expect_refused(draw + path("a.exr") + " --bits 8", 1, ".exr has 16 or 32");
    expect_refused(draw + path("a.png") + " --bits 12", 2, "--bits must be 8, 16 or 32");
    expect_refused(draw + path("a.png") + " --dpi -3", 2, "--dpi");
    expect_refused(draw + path("a.png") + " --dpi nan", 2, "--dpi");
}

TEST_F(PictureFiles, ThatArePngNeedNoOpenImageIo) {
    const std::filesystem::path modules =
        std::filesystem::path{LINEATLAS_TOOL}.parent_path() / "lib/lineatlas";
    std::filesystem::create_directory(path("modules"));
    std::filesystem::create_symlink(modules / "lineatlas-png.so", path("modules/lineatlas-png.so"));
    for (const char* options : {"", "--transparent", "--bits 16", "--bits 16 --transparent"}) {
        const std::string more = std::string{options} + " --dpi 300 --fill lambert";
        const Stored with = draw("a.tif", more); // by OpenImageIO
        ::setenv("LINEATLAS_MODULE_DIR", path("modules").c_str(), 1);
        const Stored without = draw("b.png", more);
        ::unsetenv("LINEATLAS_MODULE_DIR");
        EXPECT_EQ(draw("c.png", more).values, without.values) << options;
        EXPECT_EQ(with.values, without.values) << options;
        EXPECT_EQ(with.spec.format, without.spec.format) << options;
        EXPECT_EQ(with.spec.nchannels, without.spec.nchannels) << options;
        for (const char* note : {"XResolution", "YResolution"})
            EXPECT_NEAR(with.spec.get_float_attribute(note), without.spec.get_float_attribute(note),
                        0.02F);
        EXPECT_EQ(without.spec.get_string_attribute("ResolutionUnit"), "inch");
        for (const char* note : {"Software", "ImageDescription"})
            EXPECT_EQ(with.spec.get_string_attribute(note),
                      without.spec.get_string_attribute(note));
    }
    ::setenv("LINEATLAS_MODULE_DIR", path("modules").c_str(), 1);
    expect_refused("draw --scene clevis --size 32x24 -o " + path("a.jpg"), 1,
                   "without the package lineatlas-images, which brings OpenImageIO");
    ::unsetenv("LINEATLAS_MODULE_DIR");
}

// Mesa's zink draws GL by a Vulkan driver, here lavapipe: another rasterizer than llvmpipe's own.
// The item buffer is left out, since each driver has a unit of glPolygonOffset of its own.
TEST_F(PictureFiles, AreTheSameByZinkOnLavapipe) {
    const EnvironmentVariable software{"LIBGL_ALWAYS_SOFTWARE", "1"};
    const auto under_zink = [](const auto& action) {
        const EnvironmentVariable driver{"GALLIUM_DRIVER", "zink"};
        return action();
    };
    const Result devices = under_zink([] { return run("devices"); });
    if (devices.output.find("GL: zink") == std::string::npos)
        GTEST_SKIP() << "Mesa's zink or lavapipe is missing";
    for (const char* options :
         {"--method atlas --atlas raster --depth raster --strokes raster", "--method spine",
          "--method opengl --fill flat", "--fill toon --depth raster --strokes raster",
          "--depth raster --style pencil", "--atlas raster --set halo=4 --density 0.3"}) {
        const std::string by_cpp = std::string{"--compute cpp "} + options;
        const Stored usual = draw("a.png", by_cpp);
        const Stored shown = under_zink([&] { return draw("b.png", by_cpp); });
        ASSERT_EQ(shown.values.size(), usual.values.size());
        std::ptrdiff_t differ = 0;
        for (std::size_t i = 0; i < usual.values.size(); ++i)
            differ += std::abs(usual.values[i] - shown.values[i]) > 1.5F / 255 ? 1 : 0;
        EXPECT_LE(differ, 12) << options; // 4 pixels
    }
}

} // namespace
} // namespace lineatlas::test
