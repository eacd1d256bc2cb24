#include "object_mesh.hpp"

#include <map>
#include <tuple>

#include "models/part_names.hpp"
#include "refusal.hpp"

namespace lineatlas::threemf {

namespace {

/// The material of a triangle or an object, as the file names it.
struct Property {
    NMR::eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
    /// For base materials their group and index; for colours the colour and 0.
    DWORD first = 0, second = 0;

    auto operator<=>(const Property&) const = default;
};

DWORD packed(const NMR::MODELMESHCOLOR_SRGB& color) {
    return DWORD{color.m_Red} | DWORD{color.m_Green} << 8U | DWORD{color.m_Blue} << 16U;
}

/// The mean of a triangle's corners, because a triangle has one colour here.
NMR::MODELMESHCOLOR_SRGB mean(const NMR::MODELMESH_TRIANGLECOLOR_SRGB& corners) {
    const auto of = [&](BYTE NMR::MODELMESHCOLOR_SRGB::*channel) {
        int sum = 0;
        for (const NMR::MODELMESHCOLOR_SRGB& corner : corners.m_Colors) sum += corner.*channel;
        return static_cast<BYTE>((sum + 1) / 3);
    };
    return {of(&NMR::MODELMESHCOLOR_SRGB::m_Red), of(&NMR::MODELMESHCOLOR_SRGB::m_Green),
            of(&NMR::MODELMESHCOLOR_SRGB::m_Blue), 255};
}

Property property_of(const Handle& properties, DWORD triangle) {
    Property property;
    property.type = value<NMR::eModelPropertyType>(
        properties, NMR::lib3mf_propertyhandler_getpropertytype, triangle);
    if (property.type == NMR::MODELPROPERTYTYPE_BASEMATERIALS) {
        check(NMR::lib3mf_propertyhandler_getbasematerial(properties.get(), triangle,
                                                          &property.first, &property.second),
              properties.get());
    } else if (property.type == NMR::MODELPROPERTYTYPE_COLOR) {
        property.first = packed(mean(value<NMR::MODELMESH_TRIANGLECOLOR_SRGB>(
            properties, NMR::lib3mf_propertyhandler_getcolor, triangle)));
    }
    return property;
}

/// The property of triangles without one.
Property default_property(const Handle& object) {
    const Handle properties = get(object, NMR::lib3mf_object_createdefaultpropertyhandler);
    Property property;
    property.type = value<NMR::eModelPropertyType>(
        properties, NMR::lib3mf_defaultpropertyhandler_getpropertytype);
    if (property.type == NMR::MODELPROPERTYTYPE_BASEMATERIALS) {
        check(NMR::lib3mf_defaultpropertyhandler_getbasematerial(properties.get(), &property.first,
                                                                 &property.second),
              properties.get());
    } else if (property.type == NMR::MODELPROPERTYTYPE_COLOR) {
        property.first = packed(value<NMR::MODELMESHCOLOR_SRGB>(
            properties, NMR::lib3mf_defaultpropertyhandler_getcolor, DWORD{0}));
    }
    return property;
}

glm::vec3 color_of(BYTE red, BYTE green, BYTE blue) {
    return glm::vec3{red, green, blue} / 255.0F;
}

Material material_of(const Handle& model, const Property& property) {
    if (property.type == NMR::MODELPROPERTYTYPE_COLOR) {
        const DWORD color = property.first;
        return {.name = {},
                .color = color_of(static_cast<BYTE>(color), static_cast<BYTE>(color >> 8U),
                                  static_cast<BYTE>(color >> 16U))};
    }
    // Pictures do not count as colours.
    if (property.type != NMR::MODELPROPERTYTYPE_BASEMATERIALS || property.first == 0) return {};
    const Handle group = get(model, NMR::lib3mf_model_getbasematerialbyid, property.first);
    const std::string unnamed = "material " + std::to_string(property.second);
    BYTE red = 0, green = 0, blue = 0, alpha = 0;
    check(NMR::lib3mf_basematerial_getdisplaycolor(group.get(), property.second, &red, &green,
                                                   &blue, &alpha),
          group.get());
    return {.name = models::part_name(
                text(group, NMR::lib3mf_basematerial_getnameutf8, property.second), unnamed),
            .color = color_of(red, green, blue)};
}

void refuse_other_shapes(const Handle& object) {
    if (value<DWORD>(object, NMR::lib3mf_meshobject_getbeamcount) > 0)
        refuse("it has beam lattices, which are not supported");
    if (value<NMR::eModelSlicesMeshResolution>(object,
                                               NMR::lib3mf_meshobject_getslicesmeshresolution) ==
        NMR::MODELSLICESMESHRESOLUTION_LOW)
        refuse("a mesh in it only stands for slices, which are not supported");
}

void read_materials(const Handle& model, const Handle& object, ObjectMesh& mesh) {
    const Handle properties = get(object, NMR::lib3mf_meshobject_createpropertyhandler);
    const Property otherwise = default_property(object);
    std::map<Property, std::uint32_t> known;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Property property = property_of(properties, static_cast<DWORD>(i));
        if (property.type == NMR::MODELPROPERTYTYPE_NONE) property = otherwise;
        const auto [entry, fresh] =
            known.try_emplace(property, static_cast<std::uint32_t>(mesh.materials.size()));
        if (fresh) mesh.materials.push_back(material_of(model, property));
        mesh.triangle_material.push_back(entry->second);
    }
}

} // namespace

ObjectMesh read_mesh(const Handle& model, const Handle& object) {
    refuse_other_shapes(object);
    ObjectMesh mesh;
    const auto vertices = value<DWORD>(object, NMR::lib3mf_meshobject_getvertexcount);
    for (DWORD i = 0; i < vertices; ++i) {
        const auto vertex =
            value<NMR::MODELMESHVERTEX>(object, NMR::lib3mf_meshobject_getvertex, i);
        mesh.positions.emplace_back(vertex.m_fPosition[0], vertex.m_fPosition[1],
                                    vertex.m_fPosition[2]);
    }
    const auto triangles = value<DWORD>(object, NMR::lib3mf_meshobject_gettrianglecount);
    for (DWORD i = 0; i < triangles; ++i) {
        const auto triangle =
            value<NMR::MODELMESHTRIANGLE>(object, NMR::lib3mf_meshobject_gettriangle, i);
        for (const DWORD corner : triangle.m_nIndices)
            if (corner >= vertices) refuse("a triangle refers to a vertex that is not there");
        mesh.triangles.push_back(
            {triangle.m_nIndices[0], triangle.m_nIndices[1], triangle.m_nIndices[2]});
    }
    read_materials(model, object, mesh);
    return mesh;
}

} // namespace lineatlas::threemf
