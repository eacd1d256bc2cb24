#include "path_file.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "io/extension.hpp"
#include "pdf/pdf.hpp"

namespace lineatlas {
namespace {

struct Known {
    std::string_view extension;
    std::string_view end; ///< the last bytes of its files
};
/// In the order of PathFile.
constexpr std::array known{Known{".svg", "</svg>\n"}, Known{".json", "}\n"}, Known{".dxf", "EOF\n"},
                           Known{".pdf", "%%EOF\n"}};

} // namespace

std::optional<PathFile> path_file_type(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (known[i].extension == extension) return static_cast<PathFile>(i);
    }
    return std::nullopt;
}

std::string path_file_text(PathFile type, const VectorDrawing& drawing,
                           const PathFileOptions& options) {
    const auto with_words = [&](auto own) {
        own.description = options.description;
        own.certificate = options.certificate;
        return own;
    };
    const SvgOptions& svg = options.svg;
    switch (type) {
    case PathFile::json:
        return to_json(drawing, with_words(options.json));
    case PathFile::dxf:
        return to_dxf(drawing, with_words(DxfOptions{
                                   .page = svg.page,
                                   .margin = svg.margin,
                                   .curves = svg.curves,
                                   .fit_arcs = svg.fit_arcs,
                                   .description = {},
                                   .certificate = {},
                               }));
    case PathFile::pdf:
        return to_pdf(drawing, with_words(PdfOptions{
                                   .page = svg.page,
                                   .margin = svg.margin,
                                   .background = svg.background,
                                   .curves = svg.curves,
                                   .fit_arcs = svg.fit_arcs,
                                   .title = svg.title,
                                   .description = {},
                                   .certificate = {},
                               }));
    case PathFile::svg:
        break;
    }
    return to_svg(drawing, with_words(svg));
}

bool is_whole_path_file(PathFile type, const std::filesystem::path& path) {
    // Own files appear whole or not at all. The end tells them from files of other programs.
    std::ifstream file{path, std::ios::binary | std::ios::ate};
    const std::string_view end = known[static_cast<std::size_t>(type)].end;
    const auto size = static_cast<std::streamoff>(end.size());
    if (!file || file.tellg() < size) return false;
    file.seekg(-size, std::ios::end);
    std::string last(end.size(), ' ');
    file.read(last.data(), size);
    return last == end;
}

} // namespace lineatlas
