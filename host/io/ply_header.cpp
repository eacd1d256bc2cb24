#include "ply_header.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "text_cursor.hpp"

namespace lineatlas {

namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> types{{
    {"char", {PlyKind::with_sign, 1}},
    {"int8", {PlyKind::with_sign, 1}},
    {"uchar", {PlyKind::without_sign, 1}},
    {"uint8", {PlyKind::without_sign, 1}},
    {"short", {PlyKind::with_sign, 2}},
    {"int16", {PlyKind::with_sign, 2}},
    {"ushort", {PlyKind::without_sign, 2}},
    {"uint16", {PlyKind::without_sign, 2}},
    {"int", {PlyKind::with_sign, 4}},
    {"int32", {PlyKind::with_sign, 4}},
    {"uint", {PlyKind::without_sign, 4}},
    {"uint32", {PlyKind::without_sign, 4}},
    {"float", {PlyKind::floating, 4}},
    {"float32", {PlyKind::floating, 4}},
    {"double", {PlyKind::floating, 8}},
    {"float64", {PlyKind::floating, 8}},
}};

class HeaderText {
  public:
    explicit HeaderText(const SourceFile& source) : source_(source), bytes_(source.bytes) {}

    PlyHeader read() {
        if (line() != "ply")
            throw read_error(source_.path, "it does not start with the line \"ply\"");
        bool has_format = false;
        for (std::string_view text = line(); text != "end_header"; text = line()) {
            TextCursor words(text);
            const std::string_view keyword = words.next();
            if (keyword == "format")
                has_format = format(words.next());
            else if (keyword == "element")
                element(words);
            else if (keyword == "property")
                property(words);
            else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info")
                throw bad("has the unknown keyword \"" + printable(keyword) + '"');
        }
        if (!has_format) throw read_error(source_.path, "its header names no format");
        check_elements();
        return std::move(header_);
    }

  private:
    FileError bad(const std::string& cause) const {
        return read_error(source_.path,
                          "line " + std::to_string(header_.lines) + " of its header " + cause);
    }

    /// The next line without its end, which may be LF, CRLF or CR. Only CRLF takes two bytes:
    /// behind `end_header` any other byte belongs to the data.
    std::string_view line() {
        const std::size_t begin = header_.size;
        const std::size_t end = bytes_.find_first_of("\r\n", begin);
        if (end == bytes_.npos) throw read_error(source_.path, "its header has no \"end_header\"");
        header_.size = end + (bytes_.substr(end, 2) == "\r\n" ? 2 : 1);
        ++header_.lines;
        std::string_view text = bytes_.substr(begin, end - begin);
        while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
        return text;
    }

    bool format(std::string_view name) {
        if (name == "ascii")
            header_.encoding = PlyEncoding::ascii;
        else if (name == "binary_little_endian")
            header_.encoding = PlyEncoding::little_endian;
        else if (name == "binary_big_endian")
            header_.encoding = PlyEncoding::big_endian;
        else
            throw bad("has the unknown format \"" + printable(name) + '"');
        return true;
    }

    void element(TextCursor& words) {
        const std::string_view name = words.next();
        const auto count = parse_integer(words.next());
        if (name.empty() || !count || *count < 0) throw bad("gives no element with its count");
        if (find(name) != nullptr) throw bad("repeats the element \"" + printable(name) + '"');
        header_.elements.push_back({.name = std::string(name),
                                    .count = static_cast<std::size_t>(*count),
                                    .properties = {}});
    }

    void property(TextCursor& words) {
        if (header_.elements.empty()) throw bad("gives a property before any element");
        PlyProperty property;
        std::string_view word = words.next();
        if (word == "list") {
            property.count_type = type(words.next());
            if (property.count_type->kind == PlyKind::floating)
                throw bad("counts a list by a float");
            word = words.next();
        }
        property.type = type(word);
        property.name = words.next();
        if (property.name.empty()) throw bad("gives a property without a name");
        header_.elements.back().properties.push_back(std::move(property));
    }

    PlyType type(std::string_view name) const {
        const auto found = std::find_if(types.begin(), types.end(),
                                        [&](const auto& entry) { return entry.first == name; });
        if (found == types.end()) throw bad("has the unknown type \"" + printable(name) + '"');
        return found->second;
    }

    const PlyElement* find(std::string_view name) const {
        const auto found =
            std::find_if(header_.elements.begin(), header_.elements.end(),
                         [&](const PlyElement& element) { return element.name == name; });
        return found == header_.elements.end() ? nullptr : &*found;
    }

    void check_elements() const {
        const PlyElement* vertex = find("vertex");
        if (vertex == nullptr) throw read_error(source_.path, "its header names no vertices");
        for (const std::string_view axis : {"x", "y", "z"})
            if (std::none_of(vertex->properties.begin(), vertex->properties.end(),
                             [&](const PlyProperty& p) { return p.name == axis && !p.count_type; }))
                throw read_error(source_.path, "its vertices have no " + std::string(axis));
        const PlyElement* face = find("face");
        if (face == nullptr && find("tristrips") != nullptr)
            throw read_error(source_.path,
                             "it holds triangle strips, which are not read; save it with faces");
        if (face != nullptr && face->count > 0 &&
            std::none_of(face->properties.begin(), face->properties.end(),
                         [](const PlyProperty& p) { return p.count_type && p.is_corners(); }))
            throw read_error(source_.path, "its faces have no list \"vertex_indices\"");
    }

    const SourceFile& source_;
    std::string_view bytes_;
    PlyHeader header_;
};

} // namespace

PlyHeader read_ply_header(const SourceFile& source) {
    return HeaderText(source).read();
}

} // namespace lineatlas
