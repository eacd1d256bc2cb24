#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lineatlas::compute {

/// Whether two floats agree within `relative` of the larger magnitude; below `absolute` all do.
bool agree(float a, float b, float relative = 1e-5F, float absolute = 1e-6F);

/// What a member of a table's element is, and how exactly it must agree.
enum class FieldKind {
    byte,       ///< bit by bit
    integer,    ///< 32 bits, bit by bit
    number,     ///< a float, within 1e-5 relative or `absolute`
    channel,    ///< of a colour: a byte, within one, as rounding has it
    two_halves, ///< two floats of seven bits of mantissa, within the last of them
};

struct Field {
    std::string name;
    FieldKind kind;
    std::size_t count = 1; ///< members in a row
    float relative = 1e-5F;
    float absolute = 1e-6F; ///< below this floats are equal
};

/// The element of a table that stages write.
struct Layout {
    std::string name;
    std::vector<Field> fields; ///< in order and without gaps

    std::size_t size() const; ///< bytes
};

/// Of what KernelTable::type names.
const Layout& layout_of(std::string_view type);

/// A place where two tables differ.
struct Difference {
    std::size_t element;
    std::string field; ///< such as "start[1]"; empty where an element is one value
    std::string first, second;
};

/// The first one; nothing if two tables agree. Both have the same size.
std::optional<Difference> first_difference(const Layout& layout, std::span<const std::byte> first,
                                           std::span<const std::byte> second);

} // namespace lineatlas::compute
