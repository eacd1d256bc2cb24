#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "objects.hpp"

namespace lineatlas::gl {

/// A linked program. Uniforms are set by name. Setting a uniform that the linker has removed does
/// nothing.
class Program {
  public:
    /// Builds a program from shader files; the extension tells the stage: .vert, .geom, .frag or
    /// .comp. Throws DeviceError with the compiler's log. `defines`: names separated by spaces,
    /// defined in all of them.
    explicit Program(const std::vector<std::string_view>& files, std::string_view defines = {});

    void use() const { glUseProgram(program_.id()); }
    void set(const char* name, bool value) const { set(name, value ? 1 : 0); }
    void set(const char* name, int value) const;
    void set(const char* name, unsigned value) const;
    void set(const char* name, float value) const;
    void set(const char* name, glm::vec2 value) const;
    void set(const char* name, glm::vec4 value) const;
    void set(const char* name, glm::ivec2 value) const;
    void set(const char* name, glm::uvec2 value) const;
    void set(const char* name, glm::ivec4 value) const;
    void set(const char* name, const glm::mat4& value) const;
    void set(const char* name, std::span<const float> values) const; ///< an array
    void set(const char* name, std::span<const glm::vec4> values) const;

  private:
    struct Traits {
        static void destroy(GLuint id) { glDeleteProgram(id); }
    };
    GLint location(const char* name) const { return glGetUniformLocation(program_.id(), name); }

    Object<Traits> program_;
};

/// Programs of the same files with different defines, each built when it is first used.
class ProgramVariants {
  public:
    explicit ProgramVariants(std::vector<std::string_view> files) : files_(std::move(files)) {}
    const Program& with(std::string_view defines);

  private:
    std::vector<std::string_view> files_;
    std::map<std::string, Program, std::less<>> programs_;
};

} // namespace lineatlas::gl
