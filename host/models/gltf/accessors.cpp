#include "accessors.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

namespace lineatlas::gltf {

namespace {

enum class Component : std::uint64_t {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126,
};

/// The bytes of a component; 0 for an unknown one.
std::uint64_t size_of(Component component) {
    switch (component) {
    case Component::int8:
    case Component::uint8:
        return 1;
    case Component::int16:
    case Component::uint16:
        return 2;
    case Component::uint32:
    case Component::float32:
        return 4;
    }
    return 0;
}

template <class T>
double value_of(const char* at, bool normalized) {
    T value{};
    std::memcpy(&value, at, sizeof value);
    if (!normalized || std::is_floating_point_v<T>) return static_cast<double>(value);
    return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()),
                    -1.0);
}

double value_at(const char* at, Component component, bool normalized) {
    switch (component) {
    case Component::int8:
        return value_of<std::int8_t>(at, normalized);
    case Component::uint8:
        return value_of<std::uint8_t>(at, normalized);
    case Component::int16:
        return value_of<std::int16_t>(at, normalized);
    case Component::uint16:
        return value_of<std::uint16_t>(at, normalized);
    case Component::uint32:
        return value_of<std::uint32_t>(at, normalized);
    case Component::float32:
        return value_of<float>(at, normalized);
    }
    return 0;
}

/// Elements of `width` components each, within a view.
class Elements {
  public:
    Elements(Buffers& buffers, std::uint64_t view, std::uint64_t offset, std::uint64_t count,
             Component component, std::uint64_t width, const std::string& of)
        : component_(component) {
        const auto [bytes, stride] = buffers.view(view);
        const std::uint64_t size = size_of(component) * width;
        stride_ = stride != 0 ? stride : size;
        const bool whole =
            size != 0 && offset <= bytes.size() && stride_ >= size_of(component) &&
            (count == 0 || (size <= bytes.size() - offset &&
                            (count - 1) <= (bytes.size() - offset - size) / stride_));
        if (!whole) refuse(of + " does not fit into its buffer view");
        first_ = bytes.data() + offset;
    }

    double operator()(std::uint64_t i, std::uint64_t component, bool normalized) const {
        return value_at(first_ + i * stride_ + component * size_of(component_), component_,
                        normalized);
    }
    std::uint32_t index(std::uint64_t i) const {
        return static_cast<std::uint32_t>((*this)(i, 0, false));
    }

  private:
    Component component_;
    std::uint64_t stride_ = 0;
    const char* first_ = nullptr;
};

struct Accessor {
    const Json& json;
    std::string of;
    std::uint64_t count;
    Component component;
    bool normalized;
};

Accessor open(const Document& document, std::uint64_t index, std::string_view type) {
    const Json& json = element(document, "accessors", index);
    const std::string of = numbered("accessor", index);
    if (text(json, "type", "") != type) refuse(of + " is no " + std::string(type));
    const Json* normalized = find(json, "normalized");
    Accessor accessor{.json = json,
                      .of = of,
                      .count = whole(json, "count", of),
                      .component = Component{whole(json, "componentType", of)},
                      .normalized = normalized != nullptr && normalized->is_boolean() &&
                                    normalized->get<bool>()};
    if (size_of(accessor.component) == 0) refuse(of + " has components of an unknown type");
    return accessor;
}

double step_of(const Accessor& accessor) {
    if (accessor.component == Component::float32) return 0;
    const std::uint64_t bits = 8 * size_of(accessor.component);
    const bool has_sign =
        accessor.component == Component::int8 || accessor.component == Component::int16;
    return accessor.normalized
               ? 1 / (std::ldexp(1.0, static_cast<int>(bits - (has_sign ? 1 : 0))) - 1)
               : 1;
}

/// Limits accessors without a view, whose values are all zero. A count alone must not take
/// unlimited memory.
void check_zeros(const Accessor& accessor) {
    constexpr std::uint64_t most = 1U << 24U;
    if (accessor.count > most)
        refuse(accessor.of + " holds nothing but " + std::to_string(accessor.count) + " zeros");
}

void put_sparse(const Accessor& accessor, Buffers& buffers, Values& result) {
    const Json* sparse = find_object(accessor.json, "sparse", accessor.of);
    if (sparse == nullptr) return;
    const std::string of = "the sparse part of " + accessor.of;
    const Json* indices = find_object(*sparse, "indices", of);
    const Json* values = find_object(*sparse, "values", of);
    if (indices == nullptr || values == nullptr) refuse(of + " has no indices or no values");
    const std::uint64_t count = whole(*sparse, "count", of);
    const Elements places{buffers,
                          whole(*indices, "bufferView", of),
                          whole(*indices, "byteOffset", of, 0),
                          count,
                          Component{whole(*indices, "componentType", of)},
                          1,
                          of};
    const Elements replaced{buffers,
                            whole(*values, "bufferView", of),
                            whole(*values, "byteOffset", of, 0),
                            count,
                            accessor.component,
                            result.width,
                            of};
    for (std::uint64_t i = 0; i < count; ++i) {
        const double place = places(i, 0, false);
        if (!(place >= 0 && place < static_cast<double>(result.size())))
            refuse(of + " replaces elements that its accessor does not have");
        double* const element = &result.numbers[static_cast<std::size_t>(place) * result.width];
        for (std::uint64_t k = 0; k < result.width; ++k)
            element[k] = replaced(i, k, accessor.normalized);
    }
}

} // namespace

Values read_values(const Document& document, Buffers& buffers, std::uint64_t index,
                   std::string_view type, std::uint64_t width) {
    const Accessor accessor = open(document, index, type);
    std::optional<Elements> elements;
    if (find(accessor.json, "bufferView") != nullptr) {
        elements.emplace(buffers, whole(accessor.json, "bufferView", accessor.of),
                         whole(accessor.json, "byteOffset", accessor.of, 0), accessor.count,
                         accessor.component, width, accessor.of);
    } else {
        check_zeros(accessor);
    }
    Values values{.width = width, .numbers = std::vector<double>(accessor.count * width)};
    if (elements) {
        for (std::uint64_t i = 0; i < accessor.count; ++i)
            for (std::uint64_t k = 0; k < width; ++k)
                values.numbers[i * width + k] = (*elements)(i, k, accessor.normalized);
    }
    put_sparse(accessor, buffers, values);
    values.step = step_of(accessor);
    return values;
}

Points read_points(const Document& document, Buffers& buffers, std::uint64_t index) {
    const Values values = read_values(document, buffers, index, "VEC3", 3);
    Points points{.places = std::vector<glm::dvec3>(values.size()), .step = values.step};
    for (std::size_t i = 0; i < values.size(); ++i)
        points.places[i] = {values[i][0], values[i][1], values[i][2]};
    return points;
}

std::vector<std::uint32_t> read_indices(const Document& document, Buffers& buffers,
                                        std::uint64_t index) {
    const Accessor accessor = open(document, index, "SCALAR");
    const bool known = accessor.component == Component::uint8 ||
                       accessor.component == Component::uint16 ||
                       accessor.component == Component::uint32;
    if (!known) refuse(accessor.of + " holds indices of a signed or fractional type");
    if (find(accessor.json, "sparse") != nullptr) refuse(accessor.of + " holds sparse indices");
    const Elements elements{buffers,
                            whole(accessor.json, "bufferView", accessor.of),
                            whole(accessor.json, "byteOffset", accessor.of, 0),
                            accessor.count,
                            accessor.component,
                            1,
                            accessor.of};
    std::vector<std::uint32_t> indices(accessor.count);
    for (std::uint64_t i = 0; i < accessor.count; ++i) indices[i] = elements.index(i);
    return indices;
}

} // namespace lineatlas::gltf
