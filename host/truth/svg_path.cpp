#include "svg_path.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace lineatlas {
namespace {

class PathParser {
  public:
    explicit PathParser(std::string_view data) : rest_(data) {}

    /// Whether all of it was understood.
    bool parse() {
        while (skip_spaces(), !rest_.empty()) {
            if (std::isalpha(static_cast<unsigned char>(rest_.front())) != 0) {
                command_ = rest_.front();
                rest_.remove_prefix(1);
                if (command_ == 'z' || command_ == 'Z') {
                    line_to(start_);
                    continue;
                }
            }
            if (!step()) return false;
        }
        return true;
    }

    std::vector<std::pair<glm::dvec2, glm::dvec2>> lines;

  private:
    void skip_spaces() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" ,\t\r\n"), rest_.size()));
    }

    bool number(double& value) {
        skip_spaces();
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{}) return false;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return true;
    }

    void line_to(glm::dvec2 to) {
        lines.emplace_back(here_, to);
        here_ = to;
    }

    /// A command's numbers, once.
    bool step() {
        const bool relative = std::islower(static_cast<unsigned char>(command_)) != 0;
        const glm::dvec2 base = relative ? here_ : glm::dvec2{0};
        glm::dvec2 to{0};
        switch (std::tolower(static_cast<unsigned char>(command_))) {
        case 'm':
            if (!number(to.x) || !number(to.y)) return false;
            here_ = start_ = base + to;
            command_ = relative ? 'l' : 'L'; // more numbers are lines
            return true;
        case 'l':
            if (!number(to.x) || !number(to.y)) return false;
            line_to(base + to);
            return true;
        case 'h':
            if (!number(to.x)) return false;
            line_to({base.x + to.x, here_.y});
            return true;
        case 'v':
            if (!number(to.y)) return false;
            line_to({here_.x, base.y + to.y});
            return true;
        default:
            return false;
        }
    }

    std::string_view rest_;
    char command_ = 0;
    glm::dvec2 here_{0}, start_{0};
};

} // namespace

std::optional<std::vector<std::pair<glm::dvec2, glm::dvec2>>> parse_path(std::string_view data) {
    PathParser parser{data};
    if (!parser.parse()) return std::nullopt;
    return std::move(parser.lines);
}

} // namespace lineatlas
