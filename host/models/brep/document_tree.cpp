#include "document_tree.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include <Quantity_Color.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <glm/common.hpp>

#include "models/part_names.hpp"

namespace lineatlas::brep {

namespace {

glm::vec3 color_of(const Quantity_Color& color) {
    double red = 0, green = 0, blue = 0;
    color.Values(red, green, blue, Quantity_TOC_sRGB);
    return glm::clamp(glm::vec3{red, green, blue}, 0.0F, 1.0F);
}

// Colours of surfaces come first, then those of everything, then those of curves, because writers
// differ.
constexpr std::array color_types{XCAFDoc_ColorSurf, XCAFDoc_ColorGen, XCAFDoc_ColorCurv};

template <class What>
std::optional<glm::vec3> find_color(const Handle(XCAFDoc_ColorTool) & tool, const What& what) {
    Quantity_Color color;
    for (const XCAFDoc_ColorType type : color_types)
        if (tool->GetColor(what, type, color)) return color_of(color);
    return std::nullopt;
}

class DocumentColors : public FaceColors {
  public:
    /// Keeps the document, which holds the colours.
    DocumentColors(Handle(TDocStd_Document) document, Handle(XCAFDoc_ColorTool) tool)
        : document_(std::move(document)), tool_(std::move(tool)) {}
    std::optional<glm::vec3> color(const TopoDS_Shape& face) const override {
        return find_color(tool_, face);
    }

  private:
    Handle(TDocStd_Document) document_;
    Handle(XCAFDoc_ColorTool) tool_;
};

std::string name_of(const TDF_Label& label, std::string_view otherwise) {
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return std::string(otherwise);
    const TCollection_AsciiString text(name->Get(), '\0'); // as UTF-8
    return models::part_name({text.ToCString(), static_cast<std::size_t>(text.Length())},
                             otherwise);
}

/// Walks the tree of a document.
class Walk {
  public:
    Walk(Assembly& assembly, const Handle(TDocStd_Document) & document)
        : assembly_(assembly), shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main())),
          colors_(XCAFDoc_DocumentTool::ColorTool(document->Main())) {}

    void run() {
        TDF_LabelSequence free;
        shapes_->GetFreeShapes(free);
        for (int i = free.Length(); i >= 1; --i) left_.push_back({.label = free(i)});
        while (!left_.empty()) {
            const Step step = left_.back();
            left_.pop_back();
            visit(step);
        }
    }

  private:
    struct Step {
        TDF_Label label; ///< that of an occurrence, or of a shape at the top
        TopLoc_Location location{};
        std::uint32_t parent = ModelPart::none;
        std::optional<glm::vec3> color{}; ///< colour of the part that contains it
        int level = 0;
    };

    void visit(const Step& step) {
        constexpr int most_levels = 200;
        constexpr std::size_t most_parts = 1U << 24U;
        if (step.level > most_levels) throw std::runtime_error("its assembly is too deep");
        if (assembly_.parts.size() >= most_parts) throw std::runtime_error("it has too many parts");
        TDF_Label shape = step.label;
        if (XCAFDoc_ShapeTool::IsReference(step.label))
            XCAFDoc_ShapeTool::GetReferredShape(step.label, shape);
        const TopLoc_Location location = step.location * XCAFDoc_ShapeTool::GetLocation(step.label);
        const auto part = static_cast<std::uint32_t>(assembly_.parts.size());
        const std::string unnamed = "part " + std::to_string(part);
        assembly_.parts.push_back({.name = name_of(shape, unnamed), .parent = step.parent});

        std::optional<glm::vec3> color = find_color(colors_, step.label);
        if (!color) color = find_color(colors_, shape);
        if (!color) color = step.color;
        TDF_LabelSequence components;
        if (XCAFDoc_ShapeTool::IsAssembly(shape) &&
            XCAFDoc_ShapeTool::GetComponents(shape, components)) {
            for (int i = components.Length(); i >= 1; --i)
                left_.push_back({components(i), location, part, color, step.level + 1});
            return;
        }
        const TopoDS_Shape what = XCAFDoc_ShapeTool::GetShape(shape);
        if (what.IsNull()) return;
        // At the top a shape may have a location of its own.
        const bool placed = XCAFDoc_ShapeTool::IsReference(step.label);
        assembly_.instances.push_back(
            {.part = part,
             .shape = what.Located(TopLoc_Location()),
             .location = placed ? location : step.location * what.Location(),
             .color = color});
    }

    Assembly& assembly_;
    Handle(XCAFDoc_ShapeTool) shapes_;
    Handle(XCAFDoc_ColorTool) colors_;
    std::vector<Step> left_;
};

} // namespace

void read_document(const Handle(TDocStd_Document) & document, Assembly& assembly) {
    Walk{assembly, document}.run();
    assembly.colors = std::make_unique<DocumentColors>(
        document, XCAFDoc_DocumentTool::ColorTool(document->Main()));
}

} // namespace lineatlas::brep
