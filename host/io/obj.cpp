#include "obj.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "obj_materials.hpp"
#include "obj_text.hpp"
#include "text_cursor.hpp"

namespace lineatlas {

namespace {

/// The vertex of a corner: `1`, `-1`, `1/2`, `1//3`, `1/2/3`, with empty places (`1//`) allowed
/// behind the first.
std::optional<int> vertex_of(std::string_view corner) {
    const std::optional<int> vertex = take_number<int>(corner);
    return corner.empty() || corner.front() == '/' ? vertex : std::nullopt;
}

class ObjReader {
  public:
    ObjReader(const SourceFile& source, const ObjMaterials& materials, const ProgressPart& progress)
        : source_(source), materials_(materials), progress_(progress) {}

    Soup read() {
        const std::string_view bytes = source_.bytes;
        if (bytes.find('\0') != bytes.npos)
            throw read_error(source_.path, "it holds binary data, not OBJ text");
        for (std::string_view rest = bytes; !rest.empty();) {
            const std::string_view line = take_line(rest);
            last_ = line.end() == bytes.end();
            ++line_;
            add_line(line);
            tell(bytes.size() - rest.size());
        }
        if (!joined_.empty()) statement(joined_);
        check_corners_ahead();
        drop_nameless_group();
        return std::move(soup_);
    }

  private:
    /// A corner that names a vertex which the file had not yet.
    struct CornerAhead {
        std::size_t line = 0;
        int vertex = 0;
    };

    FileError error(const std::string& cause) const {
        return read_error(source_.path, "line " + std::to_string(line_) + ' ' + cause);
    }

    FileError truncated() const {
        return read_error(source_.path, "it is truncated: it ends in the middle of line " +
                                            std::to_string(line_));
    }

    FileError no_vertex(std::size_t line, int vertex, const std::string& place) const {
        return read_error(source_.path, "line " + std::to_string(line) + " refers to vertex " +
                                            std::to_string(vertex) + ", the file has " +
                                            std::to_string(soup_.positions.size()) + place);
    }

    void tell(std::size_t read) const {
        constexpr std::size_t every = 1U << 14U; // lines
        if (line_ % every == 0)
            progress_(static_cast<float>(read) / static_cast<float>(source_.bytes.size()));
    }

    void add_line(std::string_view line) {
        const bool continues = line.ends_with('\\') && !last_;
        if (continues) line.remove_suffix(1);
        if (!continues && joined_.empty()) {
            statement(line);
            return;
        }
        joined_ += line;
        joined_ += ' ';
        if (continues) return;
        statement(joined_);
        joined_.clear();
    }

    void statement(std::string_view rest) {
        const std::string_view keyword = take_word(rest);
        if (keyword == "v")
            add_vertex(rest);
        else if (keyword == "f" || keyword == "fo")
            add_face(rest);
        else if (keyword == "l")
            add_polyline(rest);
        else if (keyword == "o")
            set_object(rest);
        else if (keyword == "g")
            set_group(rest);
        else if (keyword == "usemtl")
            set_material(rest);
    }

    void add_vertex(std::string_view rest) {
        glm::dvec3 position{0};
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = take_word(rest);
            if (word.empty() && last_) throw truncated();
            if (word.empty()) throw error("gives a vertex fewer than three coordinates");
            position[axis] = coordinate(word);
        }
        soup_.positions.push_back(position);
    }

    double coordinate(std::string_view word) const {
        if (const auto value = parse_number(word)) return *value;
        // Visual C++ prints 1.#INF, 1.#QNAN, -1.#IND.
        if (word.find(".#") != word.npos) return std::numeric_limits<double>::quiet_NaN();
        throw error("has \"" + printable(word) + "\" for a coordinate");
    }

    void add_face(std::string_view rest) {
        read_corners(rest, 3);
        soup_.add_face(corners_);
        soup_.face_group.push_back(current_group());
    }

    void add_polyline(std::string_view rest) {
        read_corners(rest, 2);
        soup_.polylines.push_back(corners_);
    }

    void read_corners(std::string_view rest, std::size_t fewest) {
        corners_.clear();
        for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#';
             word = take_word(rest))
            corners_.push_back(corner(word));
        if (last_ && corners_.size() < fewest) throw truncated();
    }

    std::uint32_t corner(std::string_view word) {
        const std::optional<int> vertex = vertex_of(word);
        if (!vertex) throw error("has \"" + printable(word) + "\" for a vertex index");
        const auto count = static_cast<std::int64_t>(soup_.positions.size());
        if (*vertex < -count) throw no_vertex(line_, *vertex, " before it");
        if (*vertex < 0) return static_cast<std::uint32_t>(count + *vertex);
        if (*vertex == 0 || *vertex > count) add_corner_ahead(*vertex);
        return static_cast<std::uint32_t>(*vertex) - 1;
    }

    /// Such vertices are judged when all are there: those farther ahead than any before, and the
    /// first that no file can have.
    void add_corner_ahead(int vertex) {
        const bool never = vertex == 0 && !std::exchange(has_vertex_0_, true);
        if (!never && vertex <= farthest_) return;
        farthest_ = std::max(farthest_, vertex);
        corners_ahead_.push_back({line_, vertex});
    }

    void check_corners_ahead() const {
        for (const CornerAhead& ahead : corners_ahead_)
            if (ahead.vertex == 0 ||
                static_cast<std::size_t>(ahead.vertex) > soup_.positions.size())
                throw no_vertex(ahead.line, ahead.vertex, "");
    }

    void set_object(std::string_view rest) {
        object_ = trimmed(rest);
        group_.clear();
        group_known_ = false;
    }

    void set_group(std::string_view rest) {
        group_.clear();
        for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
            if (!group_.empty()) group_ += ' ';
            group_ += word;
        }
        group_known_ = false;
    }

    void set_material(std::string_view rest) {
        material_ = trimmed(rest);
        group_known_ = false;
    }

    std::uint32_t current_group() {
        if (group_known_) return group_index_;
        const bool both = !object_.empty() && !group_.empty() && object_ != group_;
        const std::string name = both ? object_ + '/' + group_ : object_.empty() ? group_ : object_;
        const auto [entry, added] = group_indices_.try_emplace(
            {name, material_}, static_cast<std::uint32_t>(soup_.groups.size()));
        if (added)
            soup_.groups.push_back(
                {.object = name, .material = material_, .color = materials_.color(material_)});
        group_index_ = entry->second;
        group_known_ = true;
        return group_index_;
    }

    /// A single one says nothing about the mesh.
    void drop_nameless_group() {
        if (soup_.groups.size() != 1 || !soup_.groups[0].object.empty() ||
            !soup_.groups[0].material.empty())
            return;
        soup_.groups.clear();
        soup_.face_group.clear();
    }

    const SourceFile& source_;
    const ObjMaterials& materials_;
    const ProgressPart& progress_;
    Soup soup_;
    std::string joined_; ///< of lines that end in a backslash
    std::size_t line_ = 0;
    bool last_ = false; ///< the line has no line end
    std::vector<std::uint32_t> corners_;
    std::vector<CornerAhead> corners_ahead_;
    int farthest_ = 0; ///< of them
    bool has_vertex_0_ = false;
    std::string object_;
    std::string group_;
    std::string material_;
    std::map<std::pair<std::string, std::string>, std::uint32_t> group_indices_;
    std::uint32_t group_index_ = 0;
    bool group_known_ = false;
};

} // namespace

Soup read_obj(const SourceFile& source, const MaterialFiles& files, const ProgressPart& progress) {
    const ObjMaterials materials(files.contents);
    Soup soup = ObjReader(source, materials, progress).read();
    soup.notes.insert(soup.notes.end(), files.notes.begin(), files.notes.end());
    return soup;
}

} // namespace lineatlas
