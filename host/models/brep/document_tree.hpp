#pragma once

#include <TDocStd_Document.hxx>

#include "assembly.hpp"

namespace lineatlas::brep {

/// Reads parts, instances and colours from a document that Open CASCADE made of a file. Throws
/// std::runtime_error if the tree is too deep or has too many parts.
void read_document(const Handle(TDocStd_Document) & document, Assembly& assembly);

} // namespace lineatlas::brep
