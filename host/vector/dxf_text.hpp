#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

namespace lineatlas {

/// The text of a DXF file: groups of a code and a value, each on a line of its own.
class DxfText {
  public:
    /// A number of an object, unlike all others in the file.
    using Handle = std::uint32_t;

    static constexpr int usual_digits = 5;

    void add(int code, std::string_view value);
    void add(int code, double value, int digits = usual_digits); ///< digits: at most so many after
                                                                 ///< the point
    void add(int code, int value);
    void add_handle(int code, Handle handle);
    /// Adds two numbers. The code of y is that of x plus 10.
    void add(int code, glm::dvec2 value);

    Handle next_handle() { return ++last_handle_; }
    Handle last_handle() const { return last_handle_; }

    /// Begins an object of a table or an entity with its type, its handle and its owner.
    Handle begin(std::string_view type, Handle owner, int handle_code = 5);
    void begin_section(std::string_view name);
    void end_section() { add(0, "ENDSEC"); }

    void append(const DxfText& other) { text_ += other.text_; }
    std::string take() { return std::move(text_); }

  private:
    Handle last_handle_ = 0;
    std::string text_;
};

/// A text as DXF holds it in a line: ASCII, with other characters by their numbers in Unicode.
std::string dxf_line(std::string_view utf8);

} // namespace lineatlas
