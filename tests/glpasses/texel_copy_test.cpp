// A shader copies texels as the driver does. A software GL does not choose the shader by itself.

#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "compare.hpp"
#include "glpasses/headless_context.hpp"
#include "glpasses/objects.hpp"
#include "glpasses/texel_copy.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{70, 50};
constexpr std::size_t texels = 70 * 50;
constexpr TexelRectangle part{{3, 5}, {64, 49}};

struct Format {
    GLenum storage, format, type;
    const char* name;
};

class TexelCopies : public testing::TestWithParam<Format> {
  protected:
    TexelCopies() {
        const Format& format = GetParam();
        std::vector<std::uint32_t> values(texels);
        std::iota(values.begin(), values.end(), 1U);
        std::vector<float> shares(texels);
        for (std::size_t i = 0; i < texels; ++i)
            shares[i] = static_cast<float>(i) / static_cast<float>(texels);
        glTextureStorage2D(texture_.id(), 1, format.storage, size.x, size.y);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTextureParameteri(texture_.id(), filter, GL_NEAREST);
        const bool numbers = format.format == GL_RED_INTEGER;
        glTextureSubImage2D(texture_.id(), 0, 0, 0, size.x, size.y, format.format, format.type,
                            numbers ? static_cast<const void*>(values.data()) : shares.data());
    }
    std::vector<std::uint32_t> copied(bool by_shader) const {
        const gl::Buffer buffer = gl::Buffer::create();
        const std::vector<std::uint32_t> before(texels, 7);
        glNamedBufferStorage(buffer.id(), texels * 4, before.data(), 0);
        gl::TexelCopy{by_shader}.copy(texture_.id(), GetParam().format, GetParam().type, size, part,
                                      buffer.id());
        std::vector<std::uint32_t> result(texels);
        glGetNamedBufferSubData(buffer.id(), 0, texels * 4, result.data());
        return result;
    }

    gl::HeadlessContext context_;
    gl::Texture2D texture_ = gl::Texture2D::create();
};

TEST_P(TexelCopies, ByAShaderAreThoseOfTheDriver) {
    const std::vector<std::uint32_t> driver = copied(false);
    EXPECT_EQ(driver[0], 7U) << "beside the part nothing is written";
    EXPECT_NE(driver[5 * 70 + 3], 7U);
    EXPECT_TRUE(equal(copied(true), driver));
}

TEST_P(TexelCopies, LeaveTheProgramsStorageBuffersBound) {
    const gl::Buffer own = gl::Buffer::create(), other = gl::Buffer::create();
    for (const gl::Buffer* buffer : {&own, &other})
        glNamedBufferStorage(buffer->id(), 4096, nullptr, 0);
    glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, own.id(), 256, 1024);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, other.id());
    copied(true);
    GLint first = 0, general = 0;
    GLint64 start = 0, bytes = 0;
    glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 0, &first);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, 0, &start);
    glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, 0, &bytes);
    glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &general);
    EXPECT_EQ(static_cast<GLuint>(first), own.id());
    EXPECT_EQ(start, 256);
    EXPECT_EQ(bytes, 1024);
    EXPECT_EQ(static_cast<GLuint>(general), other.id());
}

INSTANTIATE_TEST_SUITE_P(
    Of, TexelCopies,
    testing::Values(Format{GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, "depth"},
                    Format{GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, "numbers"},
                    Format{GL_R32F, GL_RED, GL_FLOAT, "floats"}),
    [](const auto& info) { return std::string{info.param.name}; });

} // namespace
} // namespace lineatlas::test
