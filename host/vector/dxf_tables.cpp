#include "dxf_tables.hpp"

#include <array>
#include <functional>
#include <numeric>

namespace lineatlas {
namespace {

using Handle = DxfText::Handle;

/// The handle of nobody, who owns tables and the dictionary of dictionaries.
constexpr Handle nobody = 0;

/// A table of records that `write` adds.
void write_table(DxfText& text, std::string_view name, int records,
                 const std::function<void(Handle)>& write = {}) {
    text.add(0, "TABLE");
    text.add(2, name);
    const Handle handle = text.next_handle();
    text.add_handle(5, handle);
    text.add_handle(330, nobody);
    text.add(100, "AcDbSymbolTable");
    text.add(70, records);
    if (name == "DIMSTYLE") text.add(100, "AcDbDimStyleTable");
    if (write) write(handle);
    text.add(0, "ENDTAB");
}

/// Begins a record of a table.
Handle begin_record(DxfText& text, std::string_view type, std::string_view subclass, Handle table,
                    std::string_view name) {
    const Handle handle = text.begin(type, table, type == "DIMSTYLE" ? 105 : 5);
    text.add(100, "AcDbSymbolTableRecord");
    text.add(100, subclass);
    text.add(2, name);
    return handle;
}

void write_viewport(DxfText& text, Handle table, glm::dvec2 size) {
    begin_record(text, "VPORT", "AcDbViewportTableRecord", table, "*Active");
    text.add(70, 0);
    text.add(10, glm::dvec2{0, 0}); // the whole screen
    text.add(11, glm::dvec2{1, 1});
    text.add(12, 0.5 * size); // the middle of what it shows
    text.add(40, size.y);
    text.add(41, size.x / size.y);
}

void write_linetype(DxfText& text, Handle table, std::string_view name, std::string_view looks,
                    const std::vector<double>& dashes) {
    begin_record(text, "LTYPE", "AcDbLinetypeTableRecord", table, name);
    text.add(70, 0);
    text.add(3, looks);
    text.add(72, 65); // "A", the only allowed value
    text.add(73, static_cast<int>(dashes.size()));
    text.add(40, std::accumulate(dashes.begin(), dashes.end(), 0.0));
    for (std::size_t i = 0; i < dashes.size(); ++i) {
        text.add(49, i % 2 == 0 ? dashes[i] : -dashes[i]);
        text.add(74, 0);
    }
}

void write_layer(DxfText& text, Handle table, const DxfLayer& layer) {
    begin_record(text, "LAYER", "AcDbLayerTableRecord", table, layer.name);
    text.add(70, 0);
    text.add(62, layer.shown ? layer.color_index : -layer.color_index);
    if (layer.color != 0)
        text.add(420, layer.color); // black stands for the colour that shows on
                                    // the background
    text.add(6, layer.linetype);
    text.add(370, layer.line_weight);
}

void write_text_style(DxfText& text, Handle table) {
    begin_record(text, "STYLE", "AcDbTextStyleTableRecord", table, "Standard");
    text.add(70, 0);
    text.add(40, 0.0);
    text.add(41, 1.0);
    text.add(50, 0.0);
    text.add(71, 0);
    text.add(42, 2.5);
    text.add(3, "txt");
    text.add(4, "");
}

constexpr std::array block_names{"*Model_Space", "*Paper_Space"};
using Blocks = std::array<Handle, block_names.size()>;

Blocks write_block_records(DxfText& text) {
    Blocks records{};
    write_table(text, "BLOCK_RECORD", static_cast<int>(records.size()), [&](Handle table) {
        for (std::size_t i = 0; i < records.size(); ++i)
            records[i] =
                begin_record(text, "BLOCK_RECORD", "AcDbBlockTableRecord", table, block_names[i]);
    });
    return records;
}

void write_block(DxfText& text, std::string_view name, Handle record) {
    text.begin("BLOCK", record);
    text.add(100, "AcDbEntity");
    text.add(8, "0");
    text.add(100, "AcDbBlockBegin");
    text.add(2, name);
    text.add(70, 0);
    text.add(10, glm::dvec2{0, 0});
    text.add(30, 0.0);
    text.add(3, name);
    text.add(1, "");
    text.begin("ENDBLK", record);
    text.add(100, "AcDbEntity");
    text.add(8, "0");
    text.add(100, "AcDbBlockEnd");
}

/// Begins a variable of the header.
void begin_variable(DxfText& text, std::string_view name) {
    text.add(9, name);
}

void write_point(DxfText& text, std::string_view name, glm::dvec2 point) {
    begin_variable(text, name);
    text.add(10, point);
}

void write_objects(DxfText& text) {
    text.begin_section("OBJECTS");
    const Handle root = text.begin("DICTIONARY", nobody);
    text.add(100, "AcDbDictionary");
    text.add(281, 1);
    text.add(3, "ACAD_GROUP");
    text.add_handle(350, text.last_handle() + 1);
    text.begin("DICTIONARY", root);
    text.add(100, "AcDbDictionary");
    text.add(281, 1);
    text.end_section();
}

DxfText dxf_header(glm::dvec2 size, Handle last) {
    DxfText text;
    text.begin_section("HEADER");
    begin_variable(text, "$ACADVER");
    text.add(1, "AC1018");
    begin_variable(text, "$DWGCODEPAGE");
    text.add(3, "ANSI_1252");
    begin_variable(text, "$HANDSEED");
    text.add_handle(5, last + 1);
    begin_variable(text, "$INSUNITS");
    text.add(70, 4); // millimetres
    begin_variable(text, "$MEASUREMENT");
    text.add(70, 1); // metric
    begin_variable(text, "$LTSCALE");
    text.add(40, 1.0); // patterns of linetypes are millimetres too
    begin_variable(text, "$LWDISPLAY");
    text.add(290, 1); // show widths
    write_point(text, "$EXTMIN", {0, 0});
    text.add(30, 0.0);
    write_point(text, "$EXTMAX", size);
    text.add(30, 0.0);
    write_point(text, "$LIMMIN", {0, 0});
    write_point(text, "$LIMMAX", size);
    text.end_section();
    return text;
}

/// Adds a comment in lines of at most so many characters (AutoCAD's limit is 2049).
void add_comment(DxfText& text, std::string_view comment) {
    constexpr std::size_t longest = 250;
    const std::string line = dxf_line(comment);
    for (std::size_t at = 0; at < line.size(); at += longest)
        text.add(999, std::string_view{line}.substr(at, longest));
}

} // namespace

Handle write_tables(DxfText& text, const DxfLayers& layers, glm::dvec2 size) {
    text.begin_section("TABLES");
    write_table(text, "VPORT", 1, [&](Handle table) { write_viewport(text, table, size); });
    const auto linetypes = static_cast<int>(layers.linetypes.size());
    write_table(text, "LTYPE", 3 + linetypes, [&](Handle table) {
        for (const char* name : {"ByBlock", "ByLayer"}) write_linetype(text, table, name, "", {});
        write_linetype(text, table, "CONTINUOUS", "Solid line", {});
        for (const DxfLinetype& type : layers.linetypes)
            write_linetype(text, table, type.name,
                           type.dashes.size() > 2 ? "____ . ____" : "__ __ __ __", type.dashes);
    });
    write_table(text, "LAYER", 1 + static_cast<int>(layers.layers.size()), [&](Handle table) {
        write_layer(text, table, {"0", "CONTINUOUS", 7, 0, 25});
        for (const DxfLayer& layer : layers.layers) write_layer(text, table, layer);
    });
    write_table(text, "STYLE", 1, [&](Handle table) { write_text_style(text, table); });
    write_table(text, "VIEW", 0);
    write_table(text, "UCS", 0);
    constexpr std::array applications{std::string_view{"ACAD"}, dxf_application};
    write_table(text, "APPID", static_cast<int>(applications.size()), [&](Handle table) {
        for (const std::string_view name : applications) {
            begin_record(text, "APPID", "AcDbRegAppTableRecord", table, name);
            text.add(70, 0);
        }
    });
    write_table(text, "DIMSTYLE", 1, [&](Handle table) {
        begin_record(text, "DIMSTYLE", "AcDbDimStyleTableRecord", table, "Standard");
        text.add(70, 0);
    });
    const Blocks records = write_block_records(text);
    text.end_section();
    text.begin_section("BLOCKS");
    for (std::size_t i = 0; i < records.size(); ++i) write_block(text, block_names[i], records[i]);
    text.end_section();
    return records.front();
}

std::string dxf_file(DxfText body, glm::dvec2 size, std::span<const std::string> comments) {
    write_objects(body);
    body.add(0, "EOF");
    DxfText text;
    for (const std::string& comment : comments) add_comment(text, comment);
    text.append(dxf_header(size, body.last_handle()));
    text.append(body);
    return text.take();
}

} // namespace lineatlas
