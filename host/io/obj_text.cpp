#include "obj_text.hpp"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "text_cursor.hpp"

namespace lineatlas {

namespace {

constexpr std::string_view blanks = " \t";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::string_view take_word(std::string_view& text) {
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

/// `1`, `-1`, `1/2`, `1//3`, `1/2/3`, with empty places (`1//`) allowed behind the first.
bool is_corner(std::string_view word) {
    std::size_t at = word.starts_with('-') ? 1 : 0;
    constexpr std::size_t most_digits = 9; // tinyobjloader's atoi() has no range check
    const std::size_t first = at;
    while (at < word.size() && is_digit(word[at])) ++at;
    if (at == first || at - first > most_digits) return false;
    return at == word.size() || word[at] == '/';
}

class Reduction {
  public:
    explicit Reduction(const SourceFile& source) : source_(source) {}

    ObjText run() {
        const std::string_view bytes = source_.bytes;
        if (bytes.find('\0') != bytes.npos)
            throw read_error(source_.path, "it holds binary data, not OBJ text");
        result_.text.reserve(bytes.size());
        std::size_t at = 0;
        while (at < bytes.size()) {
            const std::size_t end = std::min(bytes.find_first_of("\r\n", at), bytes.size());
            last_ = end == bytes.size();
            ++line_;
            add_line(bytes.substr(at, end - at));
            at = end + (bytes.substr(end, 2) == "\r\n" ? 2 : 1);
        }
        if (!joined_.empty()) {
            statement(joined_);
            result_.text += '\n';
        }
        return std::move(result_);
    }

  private:
    FileError error(const std::string& cause) const {
        return read_error(source_.path, "line " + std::to_string(line_) + ' ' + cause);
    }

    void add_line(std::string_view line) {
        const bool continues = line.ends_with('\\') && !last_;
        if (continues) line.remove_suffix(1);
        if (continues || !joined_.empty()) {
            joined_ += line;
            joined_ += ' ';
            if (!continues) {
                statement(joined_);
                joined_.clear();
            }
        } else {
            statement(line);
        }
        result_.text += '\n'; // also for dropped lines, so that line numbers stay those of the file
    }

    void statement(std::string_view line) {
        std::string_view rest = line;
        const std::string_view keyword = take_word(rest);
        if (keyword == "v")
            vertex(rest);
        else if (keyword == "f" || keyword == "fo")
            corners(rest, 3);
        else if (keyword == "l")
            line_element(rest);
        else if (keyword == "g" || keyword == "o" || keyword == "usemtl") {
            result_.text += keyword;
            result_.text += ' ';
            result_.text += trimmed(rest);
        }
    }

    void vertex(std::string_view rest) {
        glm::dvec3 position{0};
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = take_word(rest);
            if (word.empty() && last_) throw truncated();
            if (word.empty()) throw error("gives a vertex fewer than three coordinates");
            position[axis] = coordinate(word);
        }
        result_.positions.push_back(position);
        result_.text += "v 0 0 0"; // tinyobjloader's floats are not used
    }

    double coordinate(std::string_view word) const {
        if (const auto value = parse_number(word)) return *value;
        // Visual C++ prints 1.#INF, 1.#QNAN, -1.#IND.
        if (word.find(".#") != word.npos) return std::numeric_limits<double>::quiet_NaN();
        throw error("has \"" + printable(word) + "\" for a coordinate");
    }

    void line_element(std::string_view rest) {
        corners(rest, 2);
        result_.polyline_ends.push_back(result_.text.size());
    }

    void corners(std::string_view rest, int fewest) {
        result_.text += 'f';
        int count = 0;
        for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#';
             word = take_word(rest), ++count) {
            if (!is_corner(word)) throw error("has \"" + printable(word) + "\" for a vertex index");
            result_.text += ' ';
            result_.text += word;
        }
        if (last_ && count < fewest) throw truncated();
        if (count == 0) result_.text += " 0"; // read as a face without corners, and counted as one
    }

    FileError truncated() const {
        return read_error(source_.path, "it is truncated: it ends in the middle of line " +
                                            std::to_string(line_));
    }

    const SourceFile& source_;
    ObjText result_;
    std::string joined_; // lines that end in a backslash, joined
    std::size_t line_ = 0;
    bool last_ = false; // the line has no line end
};

} // namespace

ObjText reduce_obj(const SourceFile& source) {
    return Reduction(source).run();
}

} // namespace lineatlas
