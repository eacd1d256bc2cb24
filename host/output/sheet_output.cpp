#include "sheet_output.hpp"

#include <span>
#include <string>

#include "io/atomic_file.hpp"
#include "path_file.hpp"
#include "pdf/pdf.hpp"

namespace lineatlas {
namespace {

std::string sheet_text(PathFile type, const VectorSheet& sheet, const SheetWriting& writing) {
    if (type == PathFile::dxf) return to_dxf(sheet, writing);
    return type == PathFile::pdf ? to_pdf(sheet, writing) : to_svg(sheet, writing);
}

} // namespace

void write_sheet(const std::filesystem::path& path, const VectorSheet& sheet,
                 const SheetWriting& writing, const ImageSettings& picture) {
    const std::optional<PathFile> type = path_file_type(path);
    if (type) {
        AtomicFile file{path};
        const std::string text = sheet_text(*type, sheet, writing);
        return file.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    }
    const Image image = to_image(sheet, static_cast<double>(picture.dpi), writing);
    write_image(path,
                {.size = image.size,
                 .channels = image.channels,
                 .values = std::as_bytes(std::span{image.pixels})},
                picture);
}

} // namespace lineatlas
