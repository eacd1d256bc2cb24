// The module lineatlas-3mf: 3MF, by lib3mf.
#include "io/model_module.hpp"
#include "library.hpp"
#include "package.hpp"
#include "scene.hpp"

namespace {

using namespace lineatlas;

Soup read(const models::Request& request) {
    threemf::check_package(request.bytes);
    const threemf::Handle model = threemf::read_model(request.bytes);
    return threemf::read_scene(model);
}

} // namespace

const models::Module lineatlas_3mf_2{.prepare = [] {}, .read = read};
