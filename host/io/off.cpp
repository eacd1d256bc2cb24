#include <algorithm>
#include <string_view>
#include <utility>

#include "mesh_readers.hpp"
#include "text_cursor.hpp"

namespace lineatlas {

namespace {

/// Reads the places of vertices and the corners of faces. Ignores normals, colours and texture
/// coordinates on their lines.
class OffText {
  public:
    explicit OffText(const SourceFile& source) : source_(source), cursor_(source.bytes, '#') {}

    Soup read() {
        header();
        soup_.positions.reserve(vertices_);
        soup_.face_ends.reserve(faces_);
        soup_.corners.reserve(std::min(3 * faces_, most_numbers()));
        for (std::size_t i = 0; i < vertices_; ++i) vertex(i);
        for (std::size_t i = 0; i < faces_; ++i) face(i);
        return std::move(soup_);
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
            if (word.empty()) word = cursor_.next(); // otherwise the counts follow without a blank
        }
        if (word == "BINARY")
            throw read_error(source_.path,
                             "it is a binary OFF file; convert it to text OFF or PLY");
        vertices_ = count(word);
        faces_ = count(cursor_.next_on_line());
        cursor_.skip_line();

        constexpr std::size_t shortest_vertex = sizeof("0 0 0") - 1;
        const std::size_t room = cursor_.bytes_left() / shortest_vertex + 1;
        if (vertices_ > room || faces_ > cursor_.bytes_left())
            throw read_error(source_.path, "its header promises " +
                                               counted(vertices_, "vertex", "vertices") + " and " +
                                               counted(faces_, "face", "faces") +
                                               ", more than the file has room for");
    }

    std::size_t count(std::string_view word) const {
        const auto value = parse_integer(word);
        if (!value || *value < 0 || *value > 0x7FFFFFFF)
            throw read_error(source_.path, "line " + std::to_string(cursor_.line()) +
                                               " does not give the numbers of vertices and faces");
        return static_cast<std::size_t>(*value);
    }

    /// How many numbers the rest of the file has room for.
    std::size_t most_numbers() const { return cursor_.bytes_left() / 2 + 1; }

    void vertex(std::size_t number) {
        glm::dvec3& point = soup_.positions.emplace_back(0);
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = cursor_.next();
            if (word.empty()) throw truncated("vertex", number, vertices_);
            const auto value = parse_number(word);
            if (!value)
                throw error_in("vertex", number,
                               "has \"" + printable(word) + "\" for a coordinate");
            point[axis] = *value;
        }
        cursor_.skip_line();
    }

    void face(std::size_t number) {
        const long long corners = face_number(number);
        const auto promised = static_cast<std::size_t>(corners);
        if (corners < 0 || promised > most_numbers())
            throw error_in("face", number,
                           "claims " + std::to_string(corners) +
                               " corners, more than the file has");
        for (std::size_t i = 0; i < promised; ++i) {
            const long long index = face_number(number);
            if (index < 0 || static_cast<std::size_t>(index) >= vertices_)
                throw error_in("face", number,
                               "refers to vertex " + std::to_string(index) +
                                   ", the file has 0 to " +
                                   std::to_string(static_cast<long long>(vertices_) - 1));
            soup_.corners.push_back(static_cast<std::uint32_t>(index));
        }
        soup_.end_face();
        cursor_.skip_line();
    }

    long long face_number(std::size_t number) {
        const std::string_view word = cursor_.next();
        if (word.empty()) throw truncated("face", number, faces_);
        const auto value = parse_integer(word);
        if (!value) throw error_in("face", number, "has \"" + printable(word) + "\" for an index");
        return *value;
    }

    const SourceFile& source_;
    TextCursor cursor_;
    std::size_t vertices_ = 0, faces_ = 0; // as the header says
    Soup soup_;
};

} // namespace

Soup read_off(const SourceFile& source) {
    return OffText(source).read();
}

} // namespace lineatlas
