#include "mesh_check.hpp"

#include "fuzz.hpp"
#include "io/mesh_source.hpp"
#include "io/sound.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::fuzz {

void try_mesh(const std::filesystem::path& path) {
    try {
        const LoadedMesh loaded = parse_mesh(read_mesh_source(path)); // in this process
        expect(is_sound(loaded), "a model that is not sound");
        extract_lines(loaded.mesh);
    } catch (const FileError& error) {
        expect_good_refusal(error, path);
    }
}

} // namespace lineatlas::fuzz
