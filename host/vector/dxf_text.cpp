#include "dxf_text.hpp"

#include <fmt/format.h>

#include "path_data.hpp"
#include "xml_text.hpp"

namespace lineatlas {

void DxfText::add(int code, std::string_view value) {
    fmt::format_to(std::back_inserter(text_), "{:>3}\n{}\n", code, value);
}

void DxfText::add(int code, double value, int digits) {
    std::string text = fmt::format("{:.{}f}", value, digits);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text += '0'; // as programs write numbers that are not whole
    add(code, text == "-0.0" ? "0.0" : text);
}

void DxfText::add(int code, int value) {
    add(code, fmt::format("{}", value));
}

void DxfText::add_handle(int code, Handle handle) {
    add(code, fmt::format("{:X}", handle));
}

void DxfText::add(int code, glm::dvec2 value) {
    add(code, value.x);
    add(code + 10, value.y);
}

DxfText::Handle DxfText::begin(std::string_view type, Handle owner, int handle_code) {
    const Handle handle = next_handle();
    add(0, type);
    add_handle(handle_code, handle);
    add_handle(330, owner);
    return handle;
}

void DxfText::begin_section(std::string_view name) {
    add(0, "SECTION");
    add(2, name);
}

std::string dxf_line(std::string_view utf8) {
    const std::string clean = xml_text(utf8); // well-formed, no control characters
    std::string line;
    for (std::size_t i = 0; i < clean.size();) {
        const auto first = static_cast<unsigned char>(clean[i]);
        const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
        if (length == 1) {
            line += clean[i++];
            continue;
        }
        std::uint32_t number = first & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length; ++k)
            number = number << 6U | (static_cast<unsigned char>(clean[i + k]) & 0x3FU);
        // Codes have four digits, so characters beyond them have no code.
        line += number <= 0xFFFF ? fmt::format("\\U+{:04X}", number) : "?";
        i += length;
    }
    return line;
}

} // namespace lineatlas
