#include "bodies.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <NCollection_DataMap.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

namespace lineatlas::brep {

namespace {

/// The colours of sewn faces, which are other shapes than the faces of the file.
class SewnColors : public FaceColors {
  public:
    explicit SewnColors(std::unique_ptr<FaceColors> file) : file_(std::move(file)) {}

    std::optional<glm::vec3> color(const TopoDS_Shape& face) const override {
        if (const glm::vec3* known = sewn_.Seek(face)) return *known;
        return file_ ? file_->color(face) : std::nullopt;
    }
    void add(const TopoDS_Shape& face, const glm::vec3& color) { sewn_.Bind(face, color); }

  private:
    std::unique_ptr<FaceColors> file_;
    NCollection_DataMap<TopoDS_Shape, glm::vec3, TopTools_ShapeMapHasher> sewn_;
};

bool is_curve(const TopoDS_Shape& shape) {
    return shape.ShapeType() == TopAbs_EDGE || shape.ShapeType() == TopAbs_WIRE;
}

double size_of(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    if (box.IsVoid() || box.IsOpen()) return 0;
    return std::sqrt(box.SquareExtent());
}

/// A closed shell as a solid, whose faces look outwards; other shapes as they are.
TopoDS_Shape as_solid(const TopoDS_Shape& shape) {
    if (shape.ShapeType() != TopAbs_SHELL || !BRep_Tool::IsClosed(shape)) return shape;
    BRepBuilderAPI_MakeSolid made(TopoDS::Shell(shape));
    if (!made.IsDone()) return shape;
    TopoDS_Solid solid = made.Solid();
    BRepLib::OrientClosedSolid(solid);
    return solid;
}

TopoDS_Shape with_solids(const TopoDS_Shape& sewn) {
    if (sewn.ShapeType() != TopAbs_COMPOUND) return as_solid(sewn);
    TopoDS_Compound result;
    BRep_Builder builder;
    builder.MakeCompound(result);
    for (TopoDS_Iterator each(sewn); each.More(); each.Next())
        builder.Add(result, as_solid(each.Value()));
    return result;
}

/// A shape without a location. A lone sewn face may have one, which must not be taken for that of
/// an instance.
TopoDS_Shape without_place(const TopoDS_Shape& shape) {
    if (shape.Location().IsIdentity()) return shape;
    TopoDS_Compound around;
    BRep_Builder builder;
    builder.MakeCompound(around);
    builder.Add(around, shape);
    return around;
}

class Bodies {
  public:
    Bodies(Assembly& assembly, const ShapeNames& names, std::optional<double> tolerance)
        : assembly_(assembly), names_(names), tolerance_(tolerance),
          colors_(std::make_unique<SewnColors>(std::move(assembly.colors))) {}

    void find() {
        if (tolerance_) {
            collect_loose();
        } else {
            old_parts_ = std::exchange(assembly_.parts, {});
            old_instances_ = std::exchange(assembly_.instances, {});
        }
        // Parts of bodies stand right behind the part that contains them.
        std::vector<std::uint32_t> moved(old_parts_.size());
        std::vector<std::vector<const Instance*>> instances(old_parts_.size());
        for (const Instance& instance : old_instances_)
            instances[instance.part].push_back(&instance);
        for (std::size_t i = 0; i < old_parts_.size(); ++i) {
            ModelPart part = old_parts_[i];
            if (part.parent != ModelPart::none) part.parent = moved[part.parent];
            moved[i] = static_cast<std::uint32_t>(assembly_.parts.size());
            assembly_.parts.push_back(std::move(part));
            for (const Instance* instance : instances[i]) place(*instance, moved[i]);
        }
        assembly_.colors = std::move(colors_);
    }

  private:
    /// Collects the many faces and curves at the top that belong together into a part of each kind.
    void collect_loose() {
        BRep_Builder builder;
        TopoDS_Compound faces, curves;
        builder.MakeCompound(faces);
        builder.MakeCompound(curves);
        std::vector<bool> loose(assembly_.parts.size(), false);
        bool has_faces = false, has_curves = false;
        for (const Instance& instance : assembly_.instances) {
            if (assembly_.parts[instance.part].parent != ModelPart::none) continue;
            const bool face = instance.shape.ShapeType() == TopAbs_FACE;
            if (!face && !is_curve(instance.shape)) continue;
            const TopoDS_Shape shape = instance.shape.Located(instance.location);
            builder.Add(face ? faces : curves, shape);
            (face ? has_faces : has_curves) = true;
            loose[instance.part] = true;
            const std::optional<glm::vec3> own = colors_->color(instance.shape);
            const std::optional<glm::vec3> color = own ? own : instance.color;
            if (face && color) colors_->add(shape, *color);
        }
        std::vector<std::uint32_t> moved(assembly_.parts.size());
        for (std::size_t i = 0; i < assembly_.parts.size(); ++i) {
            if (loose[i]) continue;
            ModelPart& part = assembly_.parts[i];
            if (part.parent != ModelPart::none) part.parent = moved[part.parent];
            moved[i] = static_cast<std::uint32_t>(old_parts_.size());
            old_parts_.push_back(std::move(part));
        }
        for (Instance& instance : assembly_.instances) {
            if (loose[instance.part]) continue;
            instance.part = moved[instance.part];
            old_instances_.push_back(std::move(instance));
        }
        const auto add = [&](bool there, const char* name, const TopoDS_Shape& shape) {
            if (!there) return;
            old_instances_.push_back({.part = static_cast<std::uint32_t>(old_parts_.size()),
                                      .shape = shape,
                                      .location = TopLoc_Location(),
                                      .color = std::nullopt});
            old_parts_.push_back({.name = name});
        };
        add(has_faces, "surfaces", faces);
        add(has_curves, "curves", curves);
        assembly_.parts.clear();
        assembly_.instances.clear();
    }

    void place(const Instance& instance, std::uint32_t part) {
        std::vector<TopoDS_Shape> bodies;
        find_bodies(instance.shape, 0, bodies);
        if (!tolerance_ && std::ranges::count_if(bodies, has_solid) < 2) bodies = {instance.shape};
        int number = 0;
        for (const TopoDS_Shape& body : bodies) {
            const TopoDS_Shape here = body.Located(TopLoc_Location());
            if (!tolerance_ && !body.Location().IsIdentity()) keep_colors(body, here);
            Instance placed{.part = part,
                            .shape = tolerance_ ? sewn(here) : here,
                            .location = instance.location * body.Location(),
                            .color = bodies.size() > 1 ? color_of(body, instance) : instance.color};
            if (bodies.size() > 1) {
                placed.part = static_cast<std::uint32_t>(assembly_.parts.size());
                const std::string* name = names_.Seek(here);
                ++number;
                assembly_.parts.push_back(
                    {.name = name != nullptr ? *name : "body " + std::to_string(number),
                     .parent = part});
            }
            assembly_.instances.push_back(std::move(placed));
        }
    }

    std::optional<glm::vec3> color_of(const TopoDS_Shape& body, const Instance& instance) const {
        const std::optional<glm::vec3> own = tolerance_ ? std::nullopt : colors_->color(body);
        return own ? own : instance.color;
    }

    /// Keeps colours of a body's faces. The file's colours are found by faces with their place in
    /// the file's shape.
    void keep_colors(const TopoDS_Shape& body, const TopoDS_Shape& here) {
        TopExp_Explorer faces(here, TopAbs_FACE);
        for (TopExp_Explorer each(body, TopAbs_FACE); each.More(); each.Next(), faces.Next())
            if (const auto color = colors_->color(each.Current()))
                colors_->add(faces.Current(), *color);
    }

    static bool has_solid(const TopoDS_Shape& body) {
        return TopExp_Explorer(body, TopAbs_SOLID).More();
    }

    /// Finds bodies. A group without groups in it is one body.
    static void find_bodies(const TopoDS_Shape& shape, int level,
                            std::vector<TopoDS_Shape>& bodies) {
        constexpr int most_levels = 200;
        if (level > most_levels) throw std::runtime_error("its groups are too deep");
        bool has_groups = false;
        if (shape.ShapeType() == TopAbs_COMPOUND)
            for (TopoDS_Iterator each(shape); each.More(); each.Next())
                has_groups = has_groups || each.Value().ShapeType() < TopAbs_FACE;
        if (!has_groups) {
            bodies.push_back(shape);
            return;
        }
        TopoDS_Compound rest;
        BRep_Builder builder;
        builder.MakeCompound(rest);
        bool has_rest = false;
        for (TopoDS_Iterator each(shape); each.More(); each.Next()) {
            if (each.Value().ShapeType() < TopAbs_FACE) {
                find_bodies(each.Value(), level + 1, bodies);
            } else {
                builder.Add(rest, each.Value());
                has_rest = true;
            }
        }
        if (has_rest) bodies.push_back(rest);
    }

    /// A sewn body, the same for all its instances. Solids and shells are sewn already.
    const TopoDS_Shape& sewn(const TopoDS_Shape& body) {
        if (const TopoDS_Shape* known = sewn_.Seek(body)) return *known;
        sewn_.Bind(body, body.ShapeType() == TopAbs_COMPOUND ? sew_faces(body) : body);
        return sewn_.Find(body);
    }

    /// The one colour of all faces that have a colour. Open CASCADE loses the colours of faces that
    /// it had to mend.
    std::optional<glm::vec3> common_color(const TopoDS_Shape& group) const {
        std::optional<glm::vec3> common;
        for (TopExp_Explorer faces(group, TopAbs_FACE); faces.More(); faces.Next()) {
            const std::optional<glm::vec3> color = colors_->color(faces.Current());
            if (common && color && *common != *color) return std::nullopt;
            if (color) common = color;
        }
        return common;
    }

    /// Sews with two tolerances and returns the better result. Edges of one body may lie some
    /// micrometres apart in files of other programs. The wider tolerance counts if it leaves fewer
    /// edges free.
    Handle(BRepBuilderAPI_Sewing)
        best_sewing(const std::vector<TopoDS_Shape>& faces, double size) const {
        constexpr double share = 1e-5, wide_share = 1e-4;
        const auto sewn_within = [&](double reach) {
            const Handle(BRepBuilderAPI_Sewing) sewing =
                new BRepBuilderAPI_Sewing(std::max(*tolerance_, reach));
            for (const TopoDS_Shape& face : faces) sewing->Add(face);
            sewing->Perform();
            return sewing;
        };
        const Handle(BRepBuilderAPI_Sewing) narrow = sewn_within(share * size);
        if (narrow->SewedShape().IsNull() || narrow->NbFreeEdges() == 0 ||
            wide_share * size <= *tolerance_)
            return narrow;
        const Handle(BRepBuilderAPI_Sewing) wide = sewn_within(wide_share * size);
        const bool better =
            !wide->SewedShape().IsNull() && wide->NbFreeEdges() < narrow->NbFreeEdges();
        return better ? wide : narrow;
    }

    TopoDS_Shape sew_faces(const TopoDS_Shape& group) {
        std::vector<TopoDS_Shape> faces;
        TopoDS_Compound curves;
        BRep_Builder builder;
        builder.MakeCompound(curves);
        bool has_curves = false;
        for (TopoDS_Iterator each(group); each.More(); each.Next()) {
            if (each.Value().ShapeType() == TopAbs_FACE) {
                faces.push_back(each.Value());
            } else {
                builder.Add(curves, each.Value());
                has_curves = true;
            }
        }
        if (faces.empty()) return group;
        const Handle(BRepBuilderAPI_Sewing) sewing = best_sewing(faces, size_of(group));
        if (sewing->SewedShape().IsNull()) return group; // then faces have no common edge
        const std::optional<glm::vec3> common = common_color(group);
        for (const TopoDS_Shape& face : faces) {
            const std::optional<glm::vec3> own = colors_->color(face);
            const std::optional<glm::vec3> color = own ? own : common;
            if (color) colors_->add(sewing->ModifiedSubShape(face), *color);
        }
        const TopoDS_Shape result = without_place(with_solids(sewing->SewedShape()));
        if (!has_curves) return result;
        builder.Add(curves, result);
        return curves;
    }

    Assembly& assembly_;
    const ShapeNames& names_;
    std::optional<double> tolerance_; ///< tolerance of sewing; nothing: nothing is sewn
    std::unique_ptr<SewnColors> colors_;
    std::vector<ModelPart> old_parts_;
    std::vector<Instance> old_instances_;
    NCollection_DataMap<TopoDS_Shape, TopoDS_Shape, TopTools_ShapeMapHasher> sewn_;
};

} // namespace

void sew_bodies(Assembly& assembly, const ShapeNames& names, double tolerance) {
    Bodies{assembly, names, tolerance}.find();
}

void part_bodies(Assembly& assembly, const ShapeNames& names) {
    Bodies{assembly, names, std::nullopt}.find();
}

} // namespace lineatlas::brep
