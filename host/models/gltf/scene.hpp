#pragma once

#include "buffers.hpp"
#include "document.hpp"
#include "io/soup.hpp"

namespace lineatlas::gltf {

/// The file's scene with every node's mesh in its place, as a part and an object of its own.
Soup read_scene(const Document& document, Buffers& buffers);

} // namespace lineatlas::gltf
