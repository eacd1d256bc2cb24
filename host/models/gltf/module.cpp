// The module lineatlas-gltf: glTF 2.0 and GLB.
#include "buffers.hpp"
#include "document.hpp"
#include "io/model_module.hpp"
#include "scene.hpp"

namespace {

using namespace lineatlas;

Soup read(const models::Request& request) {
    const gltf::Document document = gltf::open_document(request.bytes);
    gltf::Buffers buffers{document, request};
    return gltf::read_scene(document, buffers);
}

} // namespace

const models::Module lineatlas_gltf_2{.prepare = [] {}, .read = read};
