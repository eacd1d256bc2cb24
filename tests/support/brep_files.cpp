#include "brep_files.hpp"

#include <sstream>
#include <stdexcept>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <StepAP214.hxx>
#include <StepAP214_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

namespace lineatlas::test {

namespace {

void name(const TDF_Label& label, const std::string& text) {
    TDataStd_Name::Set(label, TCollection_ExtendedString(text.c_str(), true));
}

Handle(TDocStd_Document) document_of(const std::vector<NamedShape>& shapes) {
    const Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    // Metres; Open CASCADE 7.8 uses the unit that was set.
    XCAFDoc_DocumentTool::SetLengthUnit(document, 0.001);
    const auto tool = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const auto colors = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const TDF_Label assembly = tool->NewShape();
    name(assembly, "assembly");
    for (const NamedShape& each : shapes) {
        const TDF_Label shape = tool->AddShape(each.shape, false);
        name(shape, each.name);
        colors->SetColor(shape, Quantity_Color(each.red, each.green, each.blue, Quantity_TOC_sRGB),
                         XCAFDoc_ColorSurf);
        for (const gp_Trsf& place : each.places)
            name(tool->AddComponent(assembly, shape, TopLoc_Location(place)), each.name);
    }
    tool->UpdateAssemblies();
    return document;
}

std::string write_step(const std::vector<NamedShape>& shapes, const char* prefix) {
    STEPCAFControl_Controller::Init();
    const Handle(TDocStd_Document) document = document_of(shapes);
    STEPCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetNameMode(true);
    if (!writer.Transfer(document, STEPControl_AsIs, prefix))
        throw std::runtime_error("Open CASCADE does not write the shapes");
    // The writer can't write to a stream, but its model can.
    std::ostringstream text;
    const auto model = writer.ChangeWriter().Model();
    APIHeaderSection_MakeHeader header(model);
    StepData_StepWriter step(model);
    step.SendModel(StepAP214::Protocol());
    step.Print(text);
    return text.str();
}

} // namespace

std::string to_step(const std::vector<NamedShape>& shapes) {
    return write_step(shapes, nullptr);
}

std::string to_step_apart(const std::vector<NamedShape>& shapes, const char* prefix) {
    return write_step(shapes, prefix);
}

std::string in_inches(std::string step) {
    const std::string millimetre = "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )";
    const std::string inch =
        "( CONVERSION_BASED_UNIT('INCH',#900001) LENGTH_UNIT() NAMED_UNIT(#900002) )";
    std::size_t count = 0; // every shape has its own unit
    for (std::size_t at = 0; (at = step.find(millimetre, at)) != std::string::npos; ++count)
        step.replace(at, millimetre.size(), inch);
    const std::string begin = "DATA;\n";
    const std::size_t data = step.find(begin);
    if (count == 0 || data == std::string::npos)
        throw std::runtime_error("Open CASCADE writes STEP otherwise");
    step.insert(data + begin.size(),
                "#900001 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#900003);\n"
                "#900002 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n#900003 = " +
                    millimetre + ";\n");
    return step;
}

std::string to_iges(const std::vector<NamedShape>& shapes, bool solids, const char* unit) {
    IGESControl_Controller::Init();
    Interface_Static::SetCVal("write.iges.unit", unit);
    Interface_Static::SetIVal("write.iges.brep.mode", solids ? 1 : 0);
    IGESCAFControl_Writer writer;
    writer.SetColorMode(true);
    writer.SetNameMode(true);
    if (!writer.Transfer(document_of(shapes)))
        throw std::runtime_error("Open CASCADE does not write the shapes");
    writer.ComputeModel();
    std::ostringstream text;
    if (!writer.Write(text)) throw std::runtime_error("Open CASCADE does not write IGES");
    return text.str();
}

std::string to_brep(const TopoDS_Shape& shape) {
    std::ostringstream text;
    BRepTools::Write(shape, text);
    return text.str();
}

TopoDS_Shape perforated_plate(int side) {
    const auto corner = [&](int x, int y) { return gp_Pnt(x * side, y * side, 0); };
    BRepBuilderAPI_MakeFace face(
        gp_Pln(gp::XOY()),
        BRepBuilderAPI_MakePolygon(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1), true)
            .Wire());
    for (int x = 0; x < side; ++x) {
        for (int y = 0; y < side; ++y) {
            const gp_Ax2 axis(gp_Pnt(x + 0.5, y + 0.5, 0), gp::DZ());
            const TopoDS_Wire hole =
                BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axis, 0.3)).Edge()).Wire();
            face.Add(TopoDS::Wire(hole.Reversed()));
        }
    }
    return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, 1)).Shape();
}

} // namespace lineatlas::test
