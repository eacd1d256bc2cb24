// Reads 3MF: a package, or the model in one. The model is tried by itself because every change
// makes the checksums of an archive wrong, and then its content is never read.
#include "fuzz.hpp"
#include "mesh_check.hpp"
#include "threemf_files.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace lineatlas;
    const std::string input{reinterpret_cast<const char*>(data), size};
    const std::string package = input.starts_with("PK") ? input : test::to_3mf(input);
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(package.data());
    fuzz::try_mesh(fuzz::put_file(".3mf", {bytes, package.size()}));
    return 0;
}
