#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "lineatlas/compute_device.hpp"
#include "segment_table.h"
#include "shared/constants.h"
#include "shared/language.h"
#include "shared/meshlet_table.h"
#include "style_numbers.h"

namespace lineatlas::compute {

using uint = std::uint32_t;
using uchar = std::uint8_t;
using la_int = std::int32_t;
using la_vec2 = glm::vec2;
using la_vec4 = glm::vec4;
using la_ivec2 = glm::ivec2;
using la_ivec4 = glm::ivec4;
using la_mat4 = glm::mat4;

#include "kernels.h"

/// Every kernel of kernels/kernels.h as a type: its Parameters, and its Tables by their names,
/// which list_of() finds among the members of groups, or among those that a launch names as its
/// own.
namespace kernels {

/// The table that a group has by a name, or null if the launch does without that table.
inline Buffer* address_of(Buffer& table) {
    return &table;
}
inline Buffer* address_of(Buffer* table) {
    return table;
}

/// The table that a name stands for, in the first of the groups that has it.
template <class Named>
Buffer* named_table(const Named&) = delete; // no group has it
template <class Named, class Group, class... Groups>
Buffer* named_table(const Named& named, const Group& group, const Groups&... groups) {
    if constexpr (std::is_invocable_v<Named, const Group&>)
        return named(group);
    else
        return named_table(named, groups...);
}

/// A table that a launch names as its own. `elsewhere`: a group has one of that name, which counts
/// if the launch names none. If no group has one, a launch without it does not compile.
template <bool elsewhere>
class OwnTable {
  public:
    OwnTable() requires elsewhere = default;
    OwnTable(Buffer* table) : table_(table) {}
    OwnTable(Buffer& table) : table_(&table) {}

    template <class Named, class... Groups>
    Buffer* or_of(const Named& named, const Groups&... groups) const {
        if constexpr (elsewhere)
            return table_ ? *table_ : named_table(named, groups...);
        else
            return *table_;
    }

  private:
    std::optional<Buffer*> table_;
};

#define LA_MEMBER(type, name) Buffer& name;
#define LA_HAS(type, name)                                                                         \
    template <class Group>                                                                         \
    static constexpr bool has_##name = requires(const Group& group) {                              \
        address_of(group.name);                                                                    \
    };
#define LA_OWN(type, name) OwnTable<(has_##name<Groups> || ...)> name{};
#define LA_GETTER(name)                                                                            \
    [](const auto& group) -> Buffer* requires requires {                                           \
        address_of(group.name);                                                                    \
    }                                                                                              \
    { return address_of(group.name); }
#define LA_NAMED(type, name) named_table(LA_GETTER(name), groups...),
#define LA_OWN_OR_NAMED(type, name) own.name.or_of(LA_GETTER(name), groups...),
#define LA_KERNEL_TYPE(stage, kernel, Parameters_)                                                 \
    struct kernel {                                                                                \
        static constexpr std::string_view name = #kernel;                                          \
        using Parameters = Parameters_;                                                            \
        struct Tables {                                                                            \
            kernel##_tables(LA_MEMBER, LA_MEMBER, LA_MEMBER, LA_MEMBER)                            \
        };                                                                                         \
        kernel##_tables(LA_HAS, LA_HAS, LA_HAS, LA_HAS) template <class... Groups>                 \
        struct Own {                                                                               \
            kernel##_tables(LA_OWN, LA_OWN, LA_OWN, LA_OWN)                                        \
        };                                                                                         \
        template <class... Groups>                                                                 \
        static auto list_of(const Groups&... groups) {                                             \
            return std::to_array<Buffer*>(                                                         \
                {kernel##_tables(LA_NAMED, LA_NAMED, LA_NAMED, LA_NAMED)});                        \
        }                                                                                          \
        template <class... Groups>                                                                 \
        static auto list_of(const Own<Groups...>& own, const Groups&... groups) {                  \
            return std::to_array<Buffer*>({kernel##_tables(LA_OWN_OR_NAMED, LA_OWN_OR_NAMED,       \
                                                           LA_OWN_OR_NAMED, LA_OWN_OR_NAMED)});    \
        }                                                                                          \
    };
LA_KERNELS(LA_KERNEL_TYPE, LA_KERNEL_TYPE, LA_KERNEL_TYPE, LA_KERNEL_TYPE, LA_KERNEL_TYPE)
#undef LA_KERNEL_TYPE
#undef LA_OWN_OR_NAMED
#undef LA_NAMED
#undef LA_GETTER
#undef LA_OWN
#undef LA_HAS
#undef LA_MEMBER

} // namespace kernels

/// The stages that are kernels, in the order of all_kernels().
std::vector<std::string_view> stage_names();

/// The first of a kernel's variants. The others follow it in all_kernels().
const Kernel& first_variant(std::string_view name);

/// A variant of a kernel. Variants are numbered through SCAN_SATURATE 0 and 1; through without
/// NUMBERED and with it; and through PROBES_PER_AXIS 1 to 4, then the same with TILED.
template <class K>
const Kernel& kernel_of(std::uint32_t variant = 0) {
    static const Kernel& first = first_variant(K::name);
    return (&first)[variant];
}

} // namespace lineatlas::compute
