#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "base/exact_bounds.hpp"
#include "base/first_seen.hpp"
#include "little_endian.hpp"
#include "mesh_readers.hpp"
#include "text_cursor.hpp"

namespace lineatlas {

namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t facet_size = 50;

using Corners = std::array<glm::vec3, 3>;

/// A coordinate; 0 in place of -0 and of subnormal numbers, which are rests of sums that were meant
/// to be zero.
float without_rest(float value) {
    return std::abs(value) < std::numeric_limits<float>::min() ? 0.0F : value;
}

glm::vec3 place_of(glm::vec3 corner) {
    return {without_rest(corner.x), without_rest(corner.y), without_rest(corner.z)};
}

/// Makes faces of a soup from facets. Equal corners become one.
class FacetWelder {
  public:
    explicit FacetWelder(std::size_t facets) : seen_(vertices_of_closed(facets)) {
        soup_.corners.reserve(3 * facets);
        soup_.face_ends.reserve(facets);
    }

    void add(const Corners& facet) {
        for (const glm::vec3& corner : facet) {
            if (is_finite(corner)) continue;
            ++soup_.not_finite_faces;
            return;
        }
        for (const glm::vec3& corner : facet) soup_.corners.push_back(weld(corner));
        soup_.end_face();
    }

    Soup take() { return std::move(soup_); }

  private:
    static std::size_t vertices_of_closed(std::size_t facets) { return facets / 2; }

    std::uint32_t weld(glm::vec3 corner) {
        const glm::vec3 place = place_of(corner);
        const auto fresh = static_cast<std::uint32_t>(soup_.positions.size());
        if (fresh == seen_.room()) make_room();
        const std::uint32_t vertex =
            seen_.find_or_add(fresh, hash_of(place), [&](std::uint32_t known) {
                return place_of(soup_.positions[known]) == place;
            });
        if (vertex == fresh) soup_.positions.emplace_back(corner);
        return vertex;
    }

    void make_room() {
        seen_ = FirstSeen(2 * soup_.positions.size());
        for (std::uint32_t i = 0; i < soup_.positions.size(); ++i)
            seen_.find_or_add(i, hash_of(place_of(soup_.positions[i])),
                              [](std::uint32_t) { return false; });
    }

    Soup soup_;
    FirstSeen seen_;
};

/// The number of facets to read. If only whole facets follow those that the header promises, the
/// header's count is wrong.
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

glm::vec3 read_corner(std::string_view bytes, std::size_t place) {
    return {read_f32(bytes, place), read_f32(bytes, place + 4), read_f32(bytes, place + 8)};
}

Soup read_binary(const SourceFile& source) {
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

    std::vector<std::string> notes;
    const std::size_t count = facets_to_read(bytes.size(), promised, notes);
    FacetWelder welder(count);
    for (std::size_t i = 0; i < count; ++i) {
        constexpr std::size_t normal_size = 12, corner_size = 12;
        const std::size_t place = header_size + i * facet_size + normal_size;
        welder.add({read_corner(bytes, place), read_corner(bytes, place + corner_size),
                    read_corner(bytes, place + 2 * corner_size)});
    }
    Soup soup = welder.take();
    soup.notes = std::move(notes);
    return soup;
}

char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool same_word(std::string_view token, std::string_view lower_case) {
    return std::ranges::equal(token, lower_case, {}, lower);
}

using Facet = std::array<glm::dvec3, 3>;

/// Walks keywords, wherever lines end.
class AsciiStl {
  public:
    explicit AsciiStl(const SourceFile& source) : source_(source), cursor_(source.bytes) {}

    Soup read() {
        bool in_solid = false;
        for (std::string_view word = cursor_.next(); !word.empty(); word = cursor_.next()) {
            if (same_word(word, "solid")) {
                in_solid = true;
                cursor_.skip_line();
            } else if (same_word(word, "facet")) {
                facets_.push_back(facet());
            } else if (is_end(word, "solid")) {
                in_solid = false;
                cursor_.skip_line();
            } else {
                throw unexpected(word, "\"facet\"");
            }
        }
        if (facets_.empty())
            throw in_solid ? truncated() : read_error(source_.path, "it holds no face");
        Soup soup = about_origin();
        if (in_solid)
            soup.notes.push_back("it ends without \"endsolid\" and may be cut off; " +
                                 counted(facets_.size(), "whole triangle", "whole triangles") +
                                 " read");
        return soup;
    }

  private:
    /// The soup, relative to an origin. Corners are welded as floats, which must be able to tell
    /// them apart.
    Soup about_origin() const {
        ExactBounds bounds;
        for (const Facet& facet : facets_)
            for (const glm::dvec3& corner : facet)
                if (is_drawable(corner)) bounds.add(corner);
        const glm::dvec3 origin = origin_for(bounds);
        FacetWelder welder(facets_.size());
        for (const auto& [a, b, c] : facets_) welder.add({a - origin, b - origin, c - origin});
        Soup soup = welder.take();
        soup.origin = origin;
        return soup;
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

    /// Some exporters write "end solid" for "endsolid", and so on.
    bool is_end(std::string_view word, std::string_view of) {
        if (same_word(word, "end" + std::string(of))) return true;
        if (!same_word(word, "end")) return false;
        expect(of);
        return true;
    }

    void expect_end(std::string_view of) {
        const std::string_view word = cursor_.next();
        if (word.empty()) throw truncated();
        if (!is_end(word, of)) throw unexpected(word, "\"end" + std::string(of) + '"');
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
        expect_end("loop");
        expect_end("facet");
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

Soup read_stl(const SourceFile& source) {
    const std::string_view bytes = source.bytes;
    const bool has_header = bytes.size() >= header_size;
    // The word "solid" proves nothing, because many exporters put it into the free text of a binary
    // header.
    const bool exact = has_header && bytes.size() == header_size + facet_size * read_u32(bytes, 80);
    const bool has_zero_byte = bytes.substr(0, 1024).find('\0') != bytes.npos;
    if (!exact && starts_with_solid(bytes) && !has_zero_byte) return AsciiStl(source).read();
    if (!exact) refuse_other_types(source, ".stl");
    if (!has_header)
        throw read_error(source.path,
                         "it is neither binary STL (too short for its header) nor ASCII "
                         "STL (does not start with \"solid\")");
    return read_binary(source);
}

} // namespace lineatlas
