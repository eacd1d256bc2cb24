#include "gltf_files.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "extension.hpp"
#include "named_files.hpp"

namespace lineatlas {

namespace {

/// More buffers than any program writes. A model must not make the reader look for files endlessly.
constexpr std::size_t most_files = 1000;

void append_utf8(std::string& text, std::uint32_t letter) {
    if (letter < 0x80) {
        text += static_cast<char>(letter);
    } else if (letter < 0x800) {
        text += static_cast<char>(0xC0U | letter >> 6U);
        text += static_cast<char>(0x80U | (letter & 0x3FU));
    } else {
        text += static_cast<char>(0xE0U | letter >> 12U);
        text += static_cast<char>(0x80U | (letter >> 6U & 0x3FU));
        text += static_cast<char>(0x80U | (letter & 0x3FU));
    }
}

/// The JSON string that begins at `at`, behind its quote. Nothing if it has no end, or characters
/// that no file name has.
std::optional<std::string> string_at(std::string_view text, std::size_t at) {
    constexpr std::size_t longest = 4096;
    std::string result;
    for (; at < text.size() && result.size() < longest; ++at) {
        if (text[at] == '"') return result;
        if (text[at] != '\\') {
            result += text[at];
            continue;
        }
        if (++at == text.size()) break;
        if (text[at] == 'u') {
            constexpr std::size_t digits = 4;
            std::uint32_t letter = 0;
            if (text.size() - at <= digits) break;
            const char* const first = text.data() + at + 1;
            if (std::from_chars(first, first + digits, letter, 16).ptr != first + digits) break;
            append_utf8(result, letter);
            at += digits;
        } else if (text[at] == '"' || text[at] == '\\' || text[at] == '/') {
            result += text[at];
        } else {
            break;
        }
    }
    return std::nullopt;
}

/// "a%20b" as "a b".
std::string without_percents(std::string_view uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char code = 0;
        const char* const digits = uri.data() + i + 1;
        const bool coded = uri[i] == '%' && uri.size() - i > 2 &&
                           std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
        name += coded ? static_cast<char>(code) : uri[i];
        if (coded) i += 2;
    }
    return name;
}

/// The JSON of a GLB file is its first chunk, behind 20 bytes.
std::string_view json_of(std::string_view file) {
    constexpr std::size_t begin = 20, length_at = 12;
    if (!file.starts_with("glTF") || file.size() < begin) return file;
    std::size_t length = 0;
    for (std::size_t i = 4; i-- > 0;)
        length = length << 8U | static_cast<unsigned char>(file[length_at + i]);
    return file.substr(begin, length);
}

bool is_picture(const std::string& uri) {
    constexpr std::array<std::string_view, 7> pictures{".png",  ".jpg", ".jpeg", ".webp",
                                                       ".ktx2", ".dds", ".basis"};
    return std::ranges::find(pictures, lower_extension(uri)) != pictures.end();
}

} // namespace

std::vector<models::NamedFile> read_gltf_files(const SourceFile& model) {
    constexpr std::string_view key = "\"uri\"", blanks = " \t\r\n";
    const std::string_view text = json_of(model.bytes);
    const NamedFiles beside{model.path};
    std::vector<models::NamedFile> files;
    for (std::size_t at = text.find(key); at != text.npos && files.size() < most_files;
         at = text.find(key, at + 1)) {
        std::size_t value = text.find_first_not_of(blanks, at + key.size());
        if (value == text.npos || text[value] != ':') continue;
        value = text.find_first_not_of(blanks, value + 1);
        if (value == text.npos || text[value] != '"' || text.substr(value + 1, 5) == "data:")
            continue;
        const std::optional<std::string> uri = string_at(text, value + 1);
        if (!uri || uri->empty() || is_picture(*uri) ||
            std::ranges::find(files, *uri, &models::NamedFile::name) != files.end())
            continue;
        models::NamedFile file{.name = *uri, .bytes = {}};
        if (beside.read(without_percents(*uri), file.bytes) == NamedFiles::Outcome::read)
            files.push_back(std::move(file));
    }
    return files;
}

} // namespace lineatlas
