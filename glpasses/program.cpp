#include "program.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <glm/gtc/type_ptr.hpp>

#include "lineatlas/error.hpp"
#include "sources/sources.hpp"

namespace lineatlas::gl {
namespace {

struct ShaderTraits {
    static void destroy(GLuint id) { glDeleteShader(id); }
};
using Shader = Object<ShaderTraits>;

GLenum stage_of(std::string_view file) {
    if (file.ends_with(".vert")) return GL_VERTEX_SHADER;
    if (file.ends_with(".geom")) return GL_GEOMETRY_SHADER;
    if (file.ends_with(".comp")) return GL_COMPUTE_SHADER;
    return GL_FRAGMENT_SHADER;
}

/// Lines that define `names`, to stand after the line with the version.
std::string define_lines(std::string_view names) {
    std::string lines;
    while (!names.empty()) {
        const std::size_t end = std::min(names.find(' '), names.size());
        if (end > 0) lines += "#define " + std::string{names.substr(0, end)} + "\n";
        names.remove_prefix(std::min(end + 1, names.size()));
    }
    return lines;
}

Shader compile(std::string_view file, std::string_view defines) {
    std::string source = shader_source(file);
    source.insert(source.find('\n') + 1, define_lines(defines));
    const char* text = source.c_str();
    Shader shader{glCreateShader(stage_of(file))};
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint compiled = 0;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (compiled == 0) {
        GLint length = 0;
        glGetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(length), ' ');
        glGetShaderInfoLog(shader.id(), length, nullptr, log.data());
        throw DeviceError("shader " + std::string{file} + " does not compile", log);
    }
    return shader;
}

} // namespace

Program::Program(const std::vector<std::string_view>& files, std::string_view defines)
    : program_(glCreateProgram()) {
    std::vector<Shader> shaders;
    for (const std::string_view file : files) {
        shaders.push_back(compile(file, defines));
        glAttachShader(program_.id(), shaders.back().id());
    }
    glLinkProgram(program_.id());
    GLint linked = 0;
    glGetProgramiv(program_.id(), GL_LINK_STATUS, &linked);
    if (linked == 0) {
        GLint length = 0;
        glGetProgramiv(program_.id(), GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(length), ' ');
        glGetProgramInfoLog(program_.id(), length, nullptr, log.data());
        throw DeviceError("shaders of " + std::string{files.front()} + " do not link", log);
    }
    for (const Shader& shader : shaders) glDetachShader(program_.id(), shader.id());
}

const Program& ProgramVariants::with(std::string_view defines) {
    const auto found = programs_.find(defines);
    if (found != programs_.end()) return found->second;
    return programs_.emplace(std::string{defines}, Program{files_, defines}).first->second;
}

void Program::set(const char* name, int value) const {
    glProgramUniform1i(program_.id(), location(name), value);
}
void Program::set(const char* name, unsigned value) const {
    glProgramUniform1ui(program_.id(), location(name), value);
}
void Program::set(const char* name, float value) const {
    glProgramUniform1f(program_.id(), location(name), value);
}
void Program::set(const char* name, glm::vec2 value) const {
    glProgramUniform2f(program_.id(), location(name), value.x, value.y);
}
void Program::set(const char* name, glm::vec4 value) const {
    glProgramUniform4f(program_.id(), location(name), value.x, value.y, value.z, value.w);
}
void Program::set(const char* name, glm::ivec2 value) const {
    glProgramUniform2i(program_.id(), location(name), value.x, value.y);
}
void Program::set(const char* name, glm::uvec2 value) const {
    glProgramUniform2ui(program_.id(), location(name), value.x, value.y);
}
void Program::set(const char* name, glm::ivec4 value) const {
    glProgramUniform4i(program_.id(), location(name), value.x, value.y, value.z, value.w);
}
void Program::set(const char* name, std::span<const glm::vec4> values) const {
    glProgramUniform4fv(program_.id(), location(name), static_cast<GLsizei>(values.size()),
                        glm::value_ptr(values.front()));
}
void Program::set(const char* name, std::span<const float> values) const {
    glProgramUniform1fv(program_.id(), location(name), static_cast<GLsizei>(values.size()),
                        values.data());
}
void Program::set(const char* name, const glm::mat4& value) const {
    glProgramUniformMatrix4fv(program_.id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}

} // namespace lineatlas::gl
