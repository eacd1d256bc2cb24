#pragma once

#include <string>

#include "lineatlas/image.hpp"
#include "lineatlas/sheet.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// How a drawing is written as PDF.
struct PdfOptions {
    /// The picture is scaled to fit on the page and centred. None: the page has the size of the
    /// picture.
    std::optional<Page> page{};
    Length margin{};                    ///< around the picture, on all four sides
    bool background = true;             ///< the paper's colour, unless it is white
    bool curves = true;                 ///< as in SvgOptions
    bool fit_arcs = false;              ///< as in SvgOptions
    std::string title = "Line drawing"; ///< title of the document
    std::string description{};          ///< the settings that made it, for people
    std::string certificate{};          ///< the result of a check of the drawing; empty: none
};

/// The drawing as a PDF of one page. Throws UsageError if the margin leaves no room. Throws
/// FileError if the module that writes PDF cannot be loaded.
std::string to_pdf(const VectorDrawing& drawing, const PdfOptions& options = {});

/// The sheet as a PDF of one page. Text of ASCII letters is in a font that is the same on every
/// machine. Throws UsageError as to_svg() of a sheet does, and FileError as above.
std::string to_pdf(const VectorSheet& sheet, const SheetWriting& writing = {});

/// The page of a sheet as a picture with `dpi` pixels per inch, 8 bits per channel. Throws as
/// above, and UsageError for a picture that is too large.
Image to_image(const VectorSheet& sheet, double dpi, const SheetWriting& writing = {});

/// Throws FileError unless the module is where it should be. Loads nothing.
void check_pdf_module();

} // namespace lineatlas
