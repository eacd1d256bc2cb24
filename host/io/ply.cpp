#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "little_endian.hpp"
#include "mesh_readers.hpp"
#include "ply_header.hpp"
#include "text_cursor.hpp"

namespace lineatlas {

namespace {

/// Returns the values behind a PLY header one by one, whatever their encoding.
class PlyValues {
  public:
    PlyValues(std::string_view bytes, PlyEncoding encoding, std::size_t first_line)
        : bytes_(bytes), encoding_(encoding), text_(bytes, 0, first_line) {}

    /// The next value. Nothing at the end of the data, or for a word that is no number.
    std::optional<double> next(const PlyType& type) {
        if (encoding_ == PlyEncoding::ascii) return parse_number(text_.next());
        if (bytes_.size() - at_ < type.size) return {};
        const std::uint64_t raw =
            read_bytes(bytes_, at_, type.size, encoding_ == PlyEncoding::big_endian);
        at_ += type.size;
        return decode(raw, type);
    }

    std::size_t bytes_left() const {
        return encoding_ == PlyEncoding::ascii ? text_.bytes_left() : bytes_.size() - at_;
    }

    /// The fewest bytes that a value of `type` takes.
    std::size_t least_size(const PlyType& type) const {
        return encoding_ == PlyEncoding::ascii ? 2 : type.size;
    }

  private:
    static double decode(std::uint64_t raw, const PlyType& type) {
        if (type.kind == PlyKind::floating)
            return type.size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(raw))
                                  : std::bit_cast<double>(raw);
        if (type.kind == PlyKind::with_sign) {
            const auto shift = static_cast<unsigned>(64 - 8 * type.size);
            return static_cast<double>(static_cast<std::int64_t>(raw << shift) >> shift);
        }
        return static_cast<double>(raw);
    }

    std::string_view bytes_;
    PlyEncoding encoding_;
    std::size_t at_ = 0;
    TextCursor text_;
};

/// Reads x, y and z of each vertex and the first list of corners of each face. Skips everything
/// else.
class PlyFile {
  public:
    PlyFile(const SourceFile& source, const PlyHeader& header)
        : source_(source), header_(header),
          values_(std::string_view(source.bytes).substr(header.size), header.encoding,
                  header.lines + 1) {}

    Soup read() {
        for (const PlyElement& element : header_.elements)
            if (element.name == "vertex") vertices_ = element.count;
        for (const PlyElement& element : header_.elements) walk(element);
        return std::move(soup_);
    }

  private:
    void walk(const PlyElement& element) {
        if (element.properties.empty()) return;
        std::size_t least = 0;
        for (const PlyProperty& property : element.properties)
            least += values_.least_size(property.count_type.value_or(property.type));
        // The last value of a text needs no blank behind it.
        if (element.count > (values_.bytes_left() + 1) / least)
            throw read_error(source_.path, "it is truncated: its header promises " +
                                               counted(element.count, "element", "elements") +
                                               " \"" + printable(element.name) +
                                               "\", it has room for " +
                                               std::to_string((values_.bytes_left() + 1) / least));
        if (element.name == "vertex")
            vertices(element);
        else if (element.name == "face")
            faces(element);
        else
            for (std::size_t i = 0; i < element.count; ++i) skip(element, i);
    }

    void vertices(const PlyElement& element) {
        soup_.positions.reserve(element.count);
        for (std::size_t i = 0; i < element.count; ++i) vertex(element, i);
    }

    void faces(const PlyElement& element) {
        soup_.face_ends.reserve(element.count);
        soup_.corners.reserve(std::min(3 * element.count, values_.bytes_left()));
        for (std::size_t i = 0; i < element.count; ++i) face(element, i);
    }

    static bool is_coordinate(const PlyProperty& property) {
        return property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z';
    }

    void vertex(const PlyElement& element, std::size_t number) {
        glm::dvec3& point = soup_.positions.emplace_back(0);
        for (const PlyProperty& property : element.properties) {
            if (property.count_type) {
                skip_list(property, element, number);
                continue;
            }
            const double value = next(property.type, element, number);
            if (is_coordinate(property)) point[property.name[0] - 'x'] = value;
        }
    }

    void face(const PlyElement& element, std::size_t number) {
        bool found = false;
        for (const PlyProperty& property : element.properties) {
            if (!property.count_type) {
                next(property.type, element, number);
            } else if (found || !property.is_corners()) {
                skip_list(property, element, number);
            } else {
                corners(property, element, number);
                found = true;
            }
        }
        soup_.end_face();
    }

    void corners(const PlyProperty& property, const PlyElement& element, std::size_t number) {
        const std::size_t count = list_count(property, element, number);
        for (std::size_t i = 0; i < count; ++i) {
            const double index = next(property.type, element, number);
            if (!is_whole_below(index, vertices_))
                throw read_error(source_.path,
                                 "face " + std::to_string(number) + " refers to vertex " +
                                     fmt::format("{}", index) + ", the file has " +
                                     counted(vertices_, "vertex", "vertices") + " from 0");
            soup_.corners.push_back(static_cast<std::uint32_t>(index));
        }
    }

    std::size_t list_count(const PlyProperty& property, const PlyElement& element,
                           std::size_t number) {
        const double count = next(*property.count_type, element, number);
        const std::size_t room = (values_.bytes_left() + 1) / values_.least_size(property.type);
        if (!is_whole_below(count, room + 1))
            throw read_error(source_.path,
                             "it is damaged or truncated: " + printable(element.name) + ' ' +
                                 std::to_string(number) + " claims " + fmt::format("{}", count) +
                                 " values of \"" + printable(property.name) +
                                 "\", which must be a whole number from 0 to " +
                                 std::to_string(room) + ", what the file has room for");
        return static_cast<std::size_t>(count);
    }

    void skip_list(const PlyProperty& property, const PlyElement& element, std::size_t number) {
        const std::size_t count = list_count(property, element, number);
        for (std::size_t i = 0; i < count; ++i) next(property.type, element, number);
    }

    void skip(const PlyElement& element, std::size_t number) {
        for (const PlyProperty& property : element.properties) {
            if (property.count_type)
                skip_list(property, element, number);
            else
                next(property.type, element, number);
        }
    }

    double next(const PlyType& type, const PlyElement& element, std::size_t number) {
        if (const auto value = values_.next(type)) return *value;
        throw read_error(source_.path, "it is damaged or truncated: no number where " +
                                           printable(element.name) + ' ' + std::to_string(number) +
                                           " of " + std::to_string(element.count) + " needs one");
    }

    static bool is_whole_below(double value, std::size_t limit) {
        return value >= 0 && value < static_cast<double>(limit) && value == std::floor(value);
    }

    const SourceFile& source_;
    const PlyHeader& header_;
    PlyValues values_;
    std::size_t vertices_ = 0; // as the header says; faces may come before vertices
    Soup soup_;
};

} // namespace

Soup read_ply(const SourceFile& source) {
    const PlyHeader header = read_ply_header(source);
    return PlyFile(source, header).read();
}

} // namespace lineatlas
