#include "draco.hpp"

#include <limits>

#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/decode.h>

#include "document.hpp"

namespace lineatlas::gltf {

DracoMesh decode_draco(std::string_view packed, std::uint64_t position, const std::string& of) {
    draco::DecoderBuffer buffer;
    buffer.Init(packed.data(), packed.size());
    draco::Decoder decoder;
    // Positions stay whole numbers, so that their grid is known.
    decoder.SetSkipAttributeTransform(draco::GeometryAttribute::POSITION);
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok() || decoded.value() == nullptr)
        refuse(of + " is damaged: its Draco data cannot be decoded");
    const draco::Mesh& mesh = *decoded.value();
    const draco::PointAttribute* attribute =
        position <= std::numeric_limits<std::uint32_t>::max()
            ? mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(position))
            : nullptr;
    if (attribute == nullptr || attribute->num_components() != 3)
        refuse(of + " has no positions in its Draco data");

    DracoMesh result;
    std::array<double, 3> least{};
    draco::AttributeQuantizationTransform grid;
    if (attribute->GetAttributeTransformData() != nullptr && grid.InitFromAttribute(*attribute)) {
        const int bits = grid.quantization_bits();
        if (bits < 1 || bits > 30) refuse(of + " is damaged: its Draco data has no grid");
        result.step = double{grid.range()} / static_cast<double>((std::uint64_t{1} << bits) - 1);
        for (int axis = 0; axis < 3; ++axis)
            least[static_cast<std::size_t>(axis)] = grid.min_value(axis);
    }
    const double step = result.step > 0 ? result.step : 1;
    result.positions.resize(mesh.num_points());
    for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
        const draco::AttributeValueIndex value = attribute->mapped_index(draco::PointIndex(i));
        std::array<double, 3> point{};
        if (value.value() >= attribute->size() ||
            !attribute->ConvertValue<double, 3>(value, point.data()))
            refuse(of + " has positions that its Draco data does not hold");
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            result.positions[i][axis] = least[k] + step * point[k];
        }
    }
    result.triangles.reserve(mesh.num_faces());
    for (std::uint32_t i = 0; i < mesh.num_faces(); ++i) {
        const draco::Mesh::Face& face = mesh.face(draco::FaceIndex(i));
        result.triangles.push_back({face[0].value(), face[1].value(), face[2].value()});
    }
    return result;
}

} // namespace lineatlas::gltf
