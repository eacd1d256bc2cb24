// Reads the mesh format of LINEATLAS_FUZZ_EXTENSION, for example ".obj".
#include "fuzz.hpp"
#include "mesh_check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lineatlas;
    fuzz::try_mesh(fuzz::put_file(LINEATLAS_FUZZ_EXTENSION, {data, size}));
    return 0;
}
