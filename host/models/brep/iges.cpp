#include "iges.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDocStd_Document.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include "bodies.hpp"
#include "document_tree.hpp"
#include "file_without_name.hpp"
#include "models/part_names.hpp"

namespace lineatlas::brep {

namespace {

/// Throws for other forms of IGES. Lines must have 80 columns with the letter of the section in the
/// 73rd.
void refuse_other_forms(std::string_view file) {
    constexpr std::size_t section = 72;
    const std::string_view line = file.substr(0, file.find_first_of("\r\n"));
    const char letter = line.size() > section ? line[section] : '\0';
    if (letter == 'C') throw std::runtime_error("it is compressed IGES, which is not supported");
    if (letter == 'B') throw std::runtime_error("it is binary IGES, which is not supported");
    if (letter != 'S')
        throw std::runtime_error("it is no IGES file: its first line has no S in column 73");
}

std::string format_of(const IGESData_GlobalSection& global) {
    switch (global.IGESVersion()) {
    case 8:
        return "IGES 5.0";
    case 9:
        return "IGES 5.1";
    case 10:
        return "IGES 5.2";
    case 11:
        return "IGES 5.3";
    default:
        return "IGES";
    }
}

void note_unit(const IGESData_GlobalSection& global, Assembly& assembly) {
    constexpr int millimetre = 2;
    constexpr std::array<const char*, 12> names{
        "",       "inches",     "millimetres", "a unit of its own", "feet",        "miles",
        "metres", "kilometres", "mils",        "micrometres",       "centimetres", "microinches"};
    const int flag = global.UnitFlag();
    if (flag == millimetre || flag < 1 || flag >= static_cast<int>(names.size())) return;
    assembly.notes.push_back("its lengths in " +
                             std::string(names[static_cast<std::size_t>(flag)]) +
                             " are drawn in millimetres");
}

/// Adds a note about shapes (not annotations) that Open CASCADE could not read.
void note_failed(IGESCAFControl_Reader& reader, Assembly& assembly) {
    constexpr int first_shape = 100, last_shape = 199;
    const auto& process = reader.WS()->TransferReader()->TransientProcess();
    int failed = 0;
    for (int i = 1; i <= reader.NbRootsForTransfer(); ++i) {
        const auto entity = Handle(IGESData_IGESEntity)::DownCast(reader.RootForTransfer(i));
        if (entity.IsNull()) continue;
        const int type = entity->TypeNumber();
        const bool is_shape = type >= first_shape && type <= last_shape;
        if (is_shape && TransferBRep::ShapeResult(process, entity).IsNull()) ++failed;
    }
    if (failed > 0)
        assembly.notes.push_back(std::to_string(failed) + (failed == 1 ? " shape" : " shapes") +
                                 " of it could not be read");
}

/// The names of shapes, which a document has only at its top.
ShapeNames names_of(IGESCAFControl_Reader& reader, const Handle(IGESData_IGESModel) & model) {
    const auto& process = reader.WS()->TransferReader()->TransientProcess();
    ShapeNames names;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto entity = Handle(IGESData_IGESEntity)::DownCast(model->Value(i));
        if (entity.IsNull() || !entity->HasName()) continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
        const Handle(TCollection_HAsciiString) name = entity->NameValue();
        if (shape.IsNull() || name.IsNull()) continue;
        const std::string text = models::part_name(name->ToCString(), "");
        // Open CASCADE writes such names for instances without one.
        if (text.empty() || text.starts_with("=>[")) continue;
        names.Bind(shape.Located(TopLoc_Location()), text);
    }
    return names;
}

/// Keeps Open CASCADE from naming shapes without a name "COMPOUND" and the like.
class NoNamesMadeUp {
  public:
    NoNamesMadeUp() : was_(XCAFDoc_ShapeTool::AutoNaming()) {
        XCAFDoc_ShapeTool::SetAutoNaming(false);
    }
    ~NoNamesMadeUp() { XCAFDoc_ShapeTool::SetAutoNaming(was_); }
    NoNamesMadeUp(const NoNamesMadeUp&) = delete;
    NoNamesMadeUp& operator=(const NoNamesMadeUp&) = delete;

  private:
    bool was_;
};

} // namespace

void prepare_iges() {
    IGESControl_Controller::Init();
    Interface_Static::SetCVal("xstep.cascade.unit", "MM");
}

Assembly read_iges(std::string_view file) {
    refuse_other_forms(file);
    prepare_iges();
    const NoNamesMadeUp naming;
    IGESCAFControl_Reader reader;
    reader.SetColorMode(true);
    reader.SetNameMode(true);
    reader.SetLayerMode(false);
    reader.SetReadVisible(true); // leaves out blanked shapes
    {
        const FileWithoutName bytes{file};
        if (reader.ReadFile(FileWithoutName::name) != IFSelect_RetDone)
            throw std::runtime_error("it is damaged or cut off: Open CASCADE cannot parse it");
    }
    const auto model = Handle(IGESData_IGESModel)::DownCast(reader.WS()->Model());
    if (model.IsNull() || model->NbEntities() == 0)
        throw std::runtime_error("it is damaged or cut off: there is nothing in it");
    Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
    if (!reader.Transfer(document)) throw std::runtime_error("it holds no shape that can be read");
    const IGESData_GlobalSection& global = model->GlobalSection();
    Assembly assembly;
    assembly.format = format_of(global);
    assembly.unit = 1;
    note_unit(global, assembly);
    note_failed(reader, assembly);
    read_document(document, assembly);
    sew_bodies(assembly, names_of(reader, model), global.Resolution() * global.UnitValue());
    return assembly;
}

} // namespace lineatlas::brep
