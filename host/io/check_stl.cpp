#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include "base/exact_bounds.hpp"
#include "checked.hpp"
#include "little_endian.hpp"
#include "text_cursor.hpp"

namespace lineatlas {

namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t facet_size = 50;

std::string empty_binary_stl() {
    return std::string(80, ' ') + std::string(4, '\0');
}

void set_facet_count(CheckedMesh& checked) {
    std::string count;
    append_u32(count, static_cast<std::uint32_t>(checked.faces));
    checked.bytes.replace(80, 4, count);
}

/// OpenMesh's reader welds through an ordered map, and one NaN breaks the order of all of it.
void add_facet(CheckedMesh& checked, const std::array<float, 9>& coordinates) {
    for (const float value : coordinates) {
        if (std::isfinite(value)) continue;
        ++checked.not_finite_faces;
        return;
    }
    checked.bytes.append(12, '\0');
    for (const float value : coordinates) append_f32(checked.bytes, value);
    checked.bytes.append(2, '\0');
    ++checked.faces;
}

/// Where nothing but whole facets follows those that the header promises, its count is wrong.
std::size_t facets_to_read(std::size_t bytes, std::size_t promised,
                           std::vector<std::string>& notes) {
    const std::size_t more = bytes - header_size - promised * facet_size;
    if (more == 0) return promised;
    const std::string header = "its header promises " + counted(promised, "triangle", "triangles");
    if (more % facet_size != 0) {
        notes.push_back(header + ", what follows is not read (" + counted(more, "byte", "bytes") +
                        ")");
        return promised;
    }
    const std::size_t present = promised + more / facet_size;
    notes.push_back(header + ", all " + std::to_string(present) + " that follow are read");
    return present;
}

CheckedMesh check_binary(const SourceFile& source) {
    const std::string_view bytes = source.bytes;
    const std::size_t promised = read_u32(bytes, 80);
    const std::size_t present = (bytes.size() - header_size) / facet_size;
    if (promised > present)
        throw read_error(source.path, "it is truncated: its header promises " +
                                          counted(promised, "triangle", "triangles") +
                                          ", it has room for " + std::to_string(present));
    if (promised == 0 && present > 0)
        throw read_error(source.path, "its header promises no triangle, but data for " +
                                          std::to_string(present) + " follow");
    if (promised == 0) throw read_error(source.path, "it holds no face");

    CheckedMesh checked;
    checked.bytes = empty_binary_stl();
    checked.bytes.reserve(bytes.size());
    const std::size_t read = facets_to_read(bytes.size(), promised, checked.notes);
    for (std::size_t i = 0; i < read; ++i) {
        std::array<float, 9> coordinates{};
        for (std::size_t c = 0; c < 9; ++c)
            coordinates[c] = read_f32(bytes, header_size + i * facet_size + 12 + 4 * c);
        add_facet(checked, coordinates);
    }
    set_facet_count(checked);
    return checked;
}

bool same_word(std::string_view token, std::string_view lower) {
    if (token.size() != lower.size()) return false;
    for (std::size_t i = 0; i < token.size(); ++i)
        if (std::tolower(static_cast<unsigned char>(token[i])) != lower[i]) return false;
    return true;
}

using Facet = std::array<glm::dvec3, 3>;

/// Walks keywords rather than lines: OpenMesh expects one `vertex` on each of the three lines
/// after `outer`, and takes anything else for zeros.
class AsciiStl {
  public:
    explicit AsciiStl(const SourceFile& source) : source_(source), cursor_(source.bytes) {}

    CheckedMesh check() {
        bool in_solid = false;
        for (std::string_view word = cursor_.next(); !word.empty(); word = cursor_.next()) {
            if (same_word(word, "solid") || same_word(word, "endsolid")) {
                in_solid = same_word(word, "solid");
                cursor_.skip_line();
            } else if (same_word(word, "facet")) {
                facets_.push_back(facet());
            } else {
                throw unexpected(word, "\"facet\"");
            }
        }
        if (in_solid) throw truncated();
        if (facets_.empty()) throw read_error(source_.path, "it holds no face");
        return about_origin();
    }

  private:
    /// OpenMesh welds floats, which must be able to tell the corners apart.
    CheckedMesh about_origin() const {
        ExactBounds bounds;
        for (const Facet& facet : facets_)
            for (const glm::dvec3& corner : facet)
                if (is_drawable(corner)) bounds.add(corner);
        CheckedMesh checked;
        checked.bytes = empty_binary_stl();
        checked.origin = origin_for(bounds);
        for (const Facet& facet : facets_) {
            std::array<float, 9> coordinates{};
            for (std::size_t i = 0; i < coordinates.size(); ++i) {
                const auto axis = static_cast<int>(i % 3);
                coordinates[i] = static_cast<float>(facet[i / 3][axis] - checked.origin[axis]);
            }
            add_facet(checked, coordinates);
        }
        set_facet_count(checked);
        return checked;
    }

    FileError truncated() const {
        return read_error(source_.path, "it is truncated: line " + std::to_string(cursor_.line()) +
                                            " is the last and no \"endsolid\" was met");
    }
    FileError unexpected(std::string_view word, std::string_view wanted) const {
        return read_error(source_.path, "line " + std::to_string(cursor_.line()) + " has \"" +
                                            printable(word) + "\" where " + std::string(wanted) +
                                            " has to be");
    }

    void expect(std::string_view wanted) {
        const std::string_view word = cursor_.next();
        if (word.empty()) throw truncated();
        if (!same_word(word, wanted)) throw unexpected(word, '"' + std::string(wanted) + '"');
    }

    double number() {
        const std::string_view word = cursor_.next();
        if (word.empty()) throw truncated();
        const auto value = parse_number(word);
        if (!value) throw unexpected(word, "a number");
        return *value;
    }

    Facet facet() {
        Facet facet{};
        expect("normal");
        for (int i = 0; i < 3; ++i)
            if (cursor_.next().empty()) throw truncated();
        expect("outer");
        expect("loop");
        for (glm::dvec3& corner : facet) {
            expect("vertex");
            for (int axis = 0; axis < 3; ++axis) corner[axis] = number();
        }
        expect("endloop");
        expect("endfacet");
        return facet;
    }

    const SourceFile& source_;
    TextCursor cursor_;
    std::vector<Facet> facets_;
};

bool starts_with_solid(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != bytes.npos && same_word(bytes.substr(first, 5), "solid");
}

} // namespace

CheckedMesh check_stl(const SourceFile& source) {
    const std::string_view bytes = source.bytes;
    const bool has_header = bytes.size() >= header_size;
    // "solid" proves nothing: many exporters put it into the free text of a binary header.
    const bool exact = has_header && bytes.size() == header_size + facet_size * read_u32(bytes, 80);
    const bool has_zero_byte = bytes.substr(0, 1024).find('\0') != bytes.npos;
    if (!exact && starts_with_solid(bytes) && !has_zero_byte) return AsciiStl(source).check();
    if (!exact) refuse_other_types(source, ".stl");
    if (!has_header)
        throw read_error(source.path,
                         "it is neither binary STL (too short for its header) nor ASCII "
                         "STL (does not start with \"solid\")");
    return check_binary(source);
}

} // namespace lineatlas
