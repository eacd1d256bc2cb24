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

    /// A child behind the ones that are there; it stays where it is in memory.
    XmlElement& add(std::string name) { return children_.emplace_back(std::move(name)); }
    XmlElement& last_child() { return children_.back(); }

    /// Text and values must be what XML may hold (xml_text.hpp); they are escaped where they are
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

/// A document of this root, as a file has it.
std::string xml_document(const XmlElement& root);

} // namespace lineatlas
