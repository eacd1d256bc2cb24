#include "sources.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr const char* kernel_folder = "LINEATLAS_KERNEL_DIR";

class SourceResolver {
  public:
    SourceResolver(const std::vector<EmbeddedSource>& embedded, const char* folder_variable,
                   bool says_lines)
        : embedded_(embedded), folder_variable_(folder_variable),
          folder_(std::getenv(folder_variable)), says_lines_(says_lines) {}

    std::string resolve(std::string_view name) {
        if (std::ranges::find(included_, name) != included_.end()) return {};
        included_.emplace_back(name);
        std::istringstream lines{text_of(name)};
        std::string result;
        std::size_t number = 1;
        for (std::string line; std::getline(lines, line); ++number) {
            constexpr std::string_view directive = "#include \"";
            if (line.starts_with(directive)) {
                const std::string_view rest = std::string_view{line}.substr(directive.size());
                const std::string included{rest.substr(0, rest.find('"'))};
                result += in_place(1, included) + resolve(included) + in_place(number + 1, name);
            } else {
                result += line;
                result += '\n';
            }
        }
        return result;
    }

  private:
    std::string in_place(std::size_t line, std::string_view file) const {
        return says_lines_ ? line_directive(line, file) : std::string{};
    }
    std::string text_of(std::string_view name) const {
        // Headers that shaders share with kernels.
        const bool shared = name.ends_with(".h") && &embedded_ != &embedded_kernels();
        if (shared) return SourceResolver{embedded_kernels(), kernel_folder, false}.text_of(name);
        if (folder_ != nullptr) {
            const std::filesystem::path path = std::filesystem::path{folder_} / name;
            std::ifstream file;
            if (std::filesystem::is_regular_file(path)) file.open(path);
            std::ostringstream text;
            text << file.rdbuf();
            if (!file.is_open() || file.bad()) {
                throw FileError("cannot read \"" + path.string() + "\", which " + folder_variable_ +
                                " names; unset it to use the built-in sources");
            }
            return text.str();
        }
        const auto found = std::ranges::find(embedded_, name, &EmbeddedSource::name);
        if (found == embedded_.end()) throw FileError("no built-in source " + std::string{name});
        return std::string{found->text};
    }

    const std::vector<EmbeddedSource>& embedded_;
    const char* folder_variable_;
    const char* folder_;
    bool says_lines_;
    std::vector<std::string> included_;
};

} // namespace

std::string line_directive(std::size_t line, std::string_view file) {
    return "#line " + std::to_string(line) + " \"" + std::string{file} + "\"\n";
}

std::string kernel_source(std::string_view name) {
    return SourceResolver{embedded_kernels(), kernel_folder, true}.resolve(name);
}

std::string shader_source(std::string_view name) {
    return SourceResolver{embedded_shaders(), "LINEATLAS_SHADER_DIR", false}.resolve(name);
}

} // namespace lineatlas
