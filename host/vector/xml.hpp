#pragma once

#include <cstddef>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lineatlas {

/// An element of an XML document that is made once and written. It holds a text or elements.
class XmlElement {
  public:
    explicit XmlElement(std::string name) : name_(std::move(name)) {}

    /// Adds a child behind the others. It keeps its place in memory.
    XmlElement& add(std::string name) { return children_.emplace_back(std::move(name)); }
    XmlElement& last_child() { return children_.back(); }

    /// Texts and values must be allowed in XML (xml_text.hpp). They are escaped when they are
    /// written.
    void set(std::string name, std::string value) {
        attributes_.emplace_back(std::move(name), std::move(value));
    }
    void set_text(std::string text) { text_ = std::move(text); }

    /// Appends the element as lines, indented by one blank for each level.
    void write(std::string& to, std::size_t level = 0) const;

  private:
    std::string name_;
    std::vector<std::pair<std::string, std::string>> attributes_;
    std::optional<std::string> text_;
    std::list<XmlElement> children_;
};

/// The text of a document with this root.
std::string xml_document(const XmlElement& root);

} // namespace lineatlas
