#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "checked.hpp"
#include "text_cursor.hpp"

namespace lineatlas {

namespace {

/// OpenMesh finds neither a keyword behind comments nor counts beside it, takes a missing edge
/// count from the first vertex, stops at `nan`, and reads on behind the end of the file. It gets
/// plain `OFF` with three zeros a vertex and bare indices a face.
class OffText {
  public:
    explicit OffText(const SourceFile& source) : source_(source), cursor_(source.bytes, '#') {}

    CheckedMesh check() {
        header();
        checked_.bytes.reserve(source_.bytes.size() + 64);
        checked_.bytes = "OFF\n" + std::to_string(checked_.vertices) + ' ' +
                         std::to_string(checked_.faces) + " 0\n";
        for (std::size_t i = 0; i < checked_.vertices; ++i) vertex(i);
        for (std::size_t i = 0; i < checked_.faces; ++i) face(i);
        return std::move(checked_);
    }

  private:
    FileError error_in(const std::string& what, std::size_t number,
                       const std::string& cause) const {
        return read_error(source_.path, what + ' ' + std::to_string(number) + " in line " +
                                            std::to_string(cursor_.line()) + ' ' + cause);
    }
    FileError truncated(const std::string& what, std::size_t number, std::size_t promised) const {
        return read_error(source_.path, "it is truncated: it ends in " + what + ' ' +
                                            std::to_string(number) + " of " +
                                            std::to_string(promised));
    }

    void header() {
        std::string_view word = cursor_.next();
        // Geomview itself lets the keyword be missing; then the counts come first.
        if (!parse_integer(word)) {
            constexpr std::string_view keyword = "OFF";
            const std::size_t place = word.find(keyword);
            if (place == word.npos)
                throw read_error(source_.path,
                                 "it does not start with the keyword OFF, but with \"" +
                                     printable(word) + '"');
            if (word.substr(0, place).find_first_of("4n") != word.npos)
                throw read_error(source_.path, "its vertices have more than three dimensions (" +
                                                   printable(word) + ")");
            word.remove_prefix(place + keyword.size());
            if (word.empty()) word = cursor_.next(); // else the counts follow without a blank
        }
        if (word == "BINARY")
            throw read_error(source_.path,
                             "it is a binary OFF file; convert it to text OFF or PLY");
        checked_.vertices = count(word);
        checked_.faces = count(cursor_.next_on_line());
        cursor_.skip_line();

        constexpr std::size_t shortest_vertex = sizeof("0 0 0") - 1;
        const std::size_t room = cursor_.bytes_left() / shortest_vertex + 1;
        if (checked_.vertices > room || checked_.faces > cursor_.bytes_left())
            throw read_error(source_.path, "its header promises " +
                                               counted(checked_.vertices, "vertex", "vertices") +
                                               " and " + counted(checked_.faces, "face", "faces") +
                                               ", more than the file has room for");
    }

    std::size_t count(std::string_view word) const {
        const auto value = parse_integer(word);
        if (!value || *value < 0 || *value > 0x7FFFFFFF)
            throw read_error(source_.path, "line " + std::to_string(cursor_.line()) +
                                               " does not give the numbers of vertices and faces");
        return static_cast<std::size_t>(*value);
    }

    void vertex(std::size_t number) {
        glm::dvec3 point{0};
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = cursor_.next();
            if (word.empty()) throw truncated("vertex", number, checked_.vertices);
            const auto value = parse_number(word);
            if (!value)
                throw error_in("vertex", number,
                               "has \"" + printable(word) + "\" for a coordinate");
            point[axis] = *value;
        }
        cursor_.skip_line();
        checked_.exact.push_back(point);
        checked_.bytes += "0 0 0\n"; // all that OpenMesh's floats are for is to be counted
    }

    void face(std::size_t number) {
        const long long corners = face_number(number);
        const auto promised = static_cast<std::size_t>(corners);
        if (corners < 0 || promised > cursor_.bytes_left() / 2 + 1)
            throw error_in("face", number,
                           "claims " + std::to_string(corners) +
                               " corners, more than the file has");
        append_number(corners);
        for (std::size_t i = 0; i < promised; ++i) {
            const long long index = face_number(number);
            if (index < 0 || static_cast<std::size_t>(index) >= checked_.vertices)
                throw error_in("face", number,
                               "refers to vertex " + std::to_string(index) +
                                   ", the file has 0 to " +
                                   std::to_string(static_cast<long long>(checked_.vertices) - 1));
            append_number(index);
        }
        cursor_.skip_line();
        checked_.bytes.back() = '\n';
    }

    long long face_number(std::size_t number) {
        const std::string_view word = cursor_.next();
        if (word.empty()) throw truncated("face", number, checked_.faces);
        const auto value = parse_integer(word);
        if (!value) throw error_in("face", number, "has \"" + printable(word) + "\" for an index");
        return *value;
    }

    template <typename Number>
    void append_number(Number number) {
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, number).ptr;
        checked_.bytes.append(text, end);
        checked_.bytes.push_back(' ');
    }

    const SourceFile& source_;
    TextCursor cursor_;
    CheckedMesh checked_;
};

} // namespace

CheckedMesh check_off(const SourceFile& source) {
    return OffText(source).check();
}

} // namespace lineatlas
