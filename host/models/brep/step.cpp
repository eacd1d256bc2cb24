#include "step.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "bodies.hpp"
#include "degenerate_torus.hpp"
#include "document_tree.hpp"
#include "memory_stream.hpp"
#include "models/part_names.hpp"

namespace lineatlas::brep {

namespace {

/// "STEP AP214", by the schema in the file's header.
std::string format_of(std::string_view file) {
    constexpr std::size_t header = 65536;
    struct Schema {
        std::string_view schema, name;
    };
    constexpr std::array schemas{
        Schema{"AP242", "STEP AP242"}, Schema{"AUTOMOTIVE_DESIGN", "STEP AP214"},
        Schema{"CONFIG_CONTROL_DESIGN", "STEP AP203"}, Schema{"AP203", "STEP AP203"}};
    const std::string_view head = file.substr(0, header);
    const std::size_t at = head.find("FILE_SCHEMA");
    if (at == head.npos) return "STEP";
    const std::string_view line = head.substr(at, head.find(';', at) - at);
    for (const Schema& schema : schemas)
        if (line.find(schema.schema) != line.npos) return std::string(schema.name);
    return "STEP";
}

void note_unit(STEPCAFControl_Reader& reader, Assembly& assembly) {
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
    if (lengths.IsEmpty()) return;
    std::string unit = models::part_name(lengths.First().ToCString(), "");
    std::ranges::transform(unit, unit.begin(), [](unsigned char c) {
        return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    });
    if (unit.empty() || unit == "millimetre" || unit == "mm") return;
    assembly.notes.push_back("its lengths in " + unit + " are drawn in millimetres");
}

/// Names of other files that have an assembly's parts, such as "HEAD.stp", "TAIL.stp" and 3 more;
/// empty if the file has all parts.
std::string other_files(const STEPCAFControl_Reader& reader) {
    constexpr std::size_t most = 5;
    std::set<std::string> names;
    for (NCollection_DataMap<TCollection_AsciiString, Handle(STEPCAFControl_ExternFile)>::Iterator
             each(reader.ExternFiles());
         each.More(); each.Next())
        names.insert('"' + models::part_name(each.Key().ToCString(), "a file") + '"');
    std::string text;
    std::size_t number = 0;
    for (const std::string& name : names) {
        if (number++ == most) return text + " and " + std::to_string(names.size() - most) + " more";
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

bool has_shapes(const Assembly& assembly) {
    return std::ranges::any_of(assembly.instances, [](const Instance& instance) {
        return TopExp_Explorer(instance.shape, TopAbs_VERTEX).More();
    });
}

/// Finds the name of a body in the file, if it has one.
void find_name(const Handle(Standard_Transient) & entity, const TopoDS_Shape& body,
               ShapeNames& names) {
    const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
    if (item.IsNull() || item->Name().IsNull()) return;
    const std::string name = models::part_name(item->Name()->ToCString(), "");
    if (!name.empty() && name != "NONE") names.Bind(body.Located(TopLoc_Location()), name);
}

/// The numbers that faces and edges have in the file, and the names of bodies.
void find_entities(STEPCAFControl_Reader& reader, Entities& entities, ShapeNames& names) {
    const Handle(XSControl_WorkSession) session = reader.Reader().WS();
    const auto model = Handle(StepData_StepModel)::DownCast(session->Model());
    const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
    if (model.IsNull() || process.IsNull()) return;
    for (int i = 1; i <= process->NbMapped(); ++i) {
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process->MapItem(i));
        if (!shape.IsNull() && shape.ShapeType() < TopAbs_FACE)
            find_name(process->Mapped(i), shape, names);
        if (shape.IsNull() ||
            (shape.ShapeType() != TopAbs_FACE && shape.ShapeType() != TopAbs_EDGE))
            continue;
        const int number = model->IdentLabel(process->Mapped(i));
        if (number > 0)
            entities.Bind(shape.Located(TopLoc_Location()), static_cast<std::uint32_t>(number));
    }
}

} // namespace

void prepare_step() {
    STEPCAFControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
}

Assembly read_step(std::string_view file) {
    constexpr std::string_view mark = "ISO-10303-21";
    if (file.substr(0, 4096).find(mark) == file.npos)
        throw std::runtime_error("it is no STEP file: \"ISO-10303-21\" is missing at its begin");
    STEPCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetLayerMode(false);
    reader.SetPropsMode(false);
    reader.SetGDTMode(false);
    reader.SetMatMode(false);
    reader.SetViewMode(false);
    MemoryBuffer buffer{file};
    std::istream stream{&buffer};
    if (reader.ChangeReader().ReadStream("model", stream) != IFSelect_RetDone)
        throw std::runtime_error("it is damaged or cut off: Open CASCADE cannot parse it");
    if (const auto model = Handle(StepData_StepModel)::DownCast(reader.Reader().WS()->Model());
        !model.IsNull())
        sweep_degenerate_tori(*model);

    Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    if (!reader.Transfer(document)) throw std::runtime_error("it holds no shape that can be read");
    Assembly assembly;
    assembly.format = format_of(file);
    assembly.unit = 1;
    note_unit(reader, assembly);
    ShapeNames names;
    find_entities(reader, assembly.entities, names);
    read_document(document, assembly);
    part_bodies(assembly, names);
    if (const std::string others = other_files(reader); !others.empty()) {
        const std::string cause = "in other files, which are not read: " + others;
        if (!has_shapes(assembly)) throw std::runtime_error("its parts are " + cause);
        assembly.notes.push_back("parts of it are " + cause);
    }
    return assembly;
}

} // namespace lineatlas::brep
