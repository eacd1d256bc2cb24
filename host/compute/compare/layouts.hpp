#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lineatlas::compute {

/// Whether two floats agree within `relative` of the larger magnitude. Any two below `absolute`
/// agree.
bool agree(float a, float b, float relative = 1e-5F, float absolute = 1e-6F);

/// The type of a member of a table's element, and how exactly it must agree.
enum class FieldKind {
    byte,       ///< bit by bit
    integer,    ///< 32 bits, bit by bit
    number,     ///< a float, within 1e-5 relative or `absolute`
    channel,    ///< a byte of a colour, within one, for rounding
    two_halves, ///< two floats with seven bits of mantissa, within the last bit
};

struct Field {
    std::string name;
    FieldKind kind;
    std::size_t count = 1; ///< members in a row
    float relative = 1e-5F;
    float absolute = 1e-6F; ///< floats below this are equal
};

/// The element of a table that stages write.
struct Layout {
    std::string name;
    std::vector<Field> fields; ///< in order and without gaps

    std::size_t size() const; ///< bytes
};

/// The layout of a type that KernelTable::type names.
const Layout& layout_of(std::string_view type);

/// A place where two tables differ.
struct Difference {
    std::size_t element;
    std::string field; ///< such as "start[1]"; empty if an element is one value
    std::string first, second;
};

/// The first difference of two tables of the same size; nothing if they agree.
std::optional<Difference> first_difference(const Layout& layout, std::span<const std::byte> first,
                                           std::span<const std::byte> second);

} // namespace lineatlas::compute
