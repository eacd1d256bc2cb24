#include "xml.hpp"

#include <fmt/format.h>

namespace lineatlas {
namespace {

/// Appends a character. In values of attributes readers would take an end of line for a blank, so
/// it is written by its number.
void append_escaped(std::string& to, char c, bool in_attribute) {
    if (c == '&') {
        to += "&amp;";
    } else if (c == '<') {
        to += "&lt;";
    } else if (c == '>' && !in_attribute) {
        to += "&gt;";
    } else if (c == '"' && in_attribute) {
        to += "&quot;";
    } else if (static_cast<unsigned char>(c) < ' ' && in_attribute) {
        to += fmt::format("&#{:02};", static_cast<int>(c));
    } else {
        to += c;
    }
}

void append_escaped(std::string& to, std::string_view text, bool in_attribute) {
    for (const char c : text) append_escaped(to, c, in_attribute);
}

} // namespace

void XmlElement::write(std::string& to, std::size_t level) const {
    to.append(level, ' ').append("<").append(name_);
    for (const auto& [name, value] : attributes_) {
        to.append(" ").append(name).append("=\"");
        append_escaped(to, value, true);
        to += '"';
    }
    if (!text_ && children_.empty()) {
        to += " />\n";
        return;
    }
    to += '>';
    if (text_) {
        append_escaped(to, *text_, false);
    } else {
        to += '\n';
        for (const XmlElement& child : children_) child.write(to, level + 1);
        to.append(level, ' ');
    }
    to.append("</").append(name_).append(">\n");
}

std::string xml_document(const XmlElement& root) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    root.write(text);
    return text;
}

} // namespace lineatlas
