#pragma once

#include "buffers.hpp"
#include "document.hpp"
#include "io/soup.hpp"

namespace lineatlas::gltf {

/// The file's scene with every node's mesh where the node puts it, a part and an object of its own.
Soup read_scene(const Document& document, Buffers& buffers);

} // namespace lineatlas::gltf
