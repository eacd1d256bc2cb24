#include "sources.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

class SourceResolver {
  public:
    SourceResolver(const std::vector<EmbeddedSource>& embedded, const char* folder_variable)
        : embedded_(embedded), folder_variable_(folder_variable),
          folder_(std::getenv(folder_variable)) {}

    std::string resolve(std::string_view name) {
        if (std::ranges::find(included_, name) != included_.end()) return {};
        included_.emplace_back(name);
        std::istringstream lines{text_of(name)};
        std::string result;
        for (std::string line; std::getline(lines, line);) {
            constexpr std::string_view directive = "#include \"";
            if (line.starts_with(directive)) {
                const std::string_view rest = std::string_view{line}.substr(directive.size());
                result += resolve(std::string{rest.substr(0, rest.find('"'))});
            } else {
                result += line;
                result += '\n';
            }
        }
        return result;
    }

  private:
    std::string text_of(std::string_view name) const {
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
    std::vector<std::string> included_;
};

} // namespace

std::string kernel_source(std::string_view name) {
    return SourceResolver{embedded_kernels(), "LINEATLAS_KERNEL_DIR"}.resolve(name);
}

std::string shader_source(std::string_view name) {
    return SourceResolver{embedded_shaders(), "LINEATLAS_SHADER_DIR"}.resolve(name);
}

} // namespace lineatlas
