#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <glm/vec2.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/image.hpp"
#include "lineatlas/loaded_mesh.hpp"
#include "lineatlas/progress.hpp"

/// @file
/// Models and pictures, from files and to files.
/// @code{.cpp}
/// const LoadedMesh model = load_mesh("house.obj");
/// for (const std::string& note : model.notes) std::cerr << note << '\n';
/// write_image("grey.png", Image{.size = {1, 2}, .channels = 1, .pixels = {0, 255}});
/// @endcode

namespace lineatlas {

/// How models are read.
struct LoadOptions {
    /// For STEP, IGES and BREP: how far a triangle's side may be off a curved face, in millimetres,
    /// or in the file's own unit if the file names none. 0: a quarter of one of `pixels`.
    double deflection = 0;
    /// The length in pixels at which the diagonal of such a model is drawn, 1 to 1e6. The default
    /// is the diagonal of a picture of 1024 x 768.
    double pixels = 1280;
    /// For STEP, IGES and BREP, which are read in a process of their own: how much memory that
    /// process may take, in GiB; 0: 2 GiB plus 32 times the file's size.
    double read_memory = 0;
    double read_seconds = 0; ///< how much time it may take; 0: 60 s plus one for each MB of the
                             ///< file
};

/// Reads OBJ (groups, materials and `l` elements included), PLY, STL, OFF and OM. Modules, loaded
/// when they are needed, read glTF and GLB, 3MF, STEP, IGES and BREP. The extension, in upper or
/// lower case, chooses the format. Throws FileError, one line that names the file and the cause,
/// when the file is missing, empty, truncated, of another type than its name says, refers to
/// vertices it does not have, or holds no triangle and no polyline. May be called from several
/// threads.
///
/// STEP, IGES and BREP are read by Open CASCADE, which crashes on many damaged files. So they are
/// read in a confined process, the program `lineatlas-reader` beside the module, which ends with
/// the call. A crash, and too much memory or time, are a FileError, too.
///
/// Polygons are triangulated, concave ones included. Positions are those of the file less
/// LoadedMesh::origin. Only STL, which has no indices, is welded at equal positions. Faces with
/// coordinates that are not finite or beyond 1e15 are dropped. A group is one pair of object
/// and material in an OBJ file, its object named `o`, `g`, or `o/g` where both are given; its
/// colour comes from the .mtl file; a note says so if that file is missing. OBJ files without
/// names, and the other mesh types, have no groups. Instances in scenes and assemblies
/// become triangles of their own, with a group for each of them and its materials.
///
/// Throws Cancelled if `progress` returns false. For OBJ files `progress` is called all along, for
/// others after the file was read into memory and after it was parsed.
LINEATLAS_API LoadedMesh load_mesh(const std::filesystem::path& path,
                                   const LoadOptions& options = {}, const Progress& progress = {});

/// The pixels of a picture to be written, as Image holds them, with 8 or 16 bits per value.
struct Pixels {
    glm::ivec2 size{0, 0};               ///< width and height
    int channels = 4;                    ///< 1 to 4
    int bits = 8;                        ///< per value: 8 or 16
    bool premultiplied = false;          ///< colour is multiplied by alpha, as GL draws it
    std::span<const std::byte> values{}; ///< size.x * size.y * channels numbers in native order
};

/// What a picture file holds besides its pixels.
struct ImageSettings {
    int bits = 0;              ///< per channel; 0: the usual number of the file type (EXR 16,
                               ///< others 8)
    float dpi = 0;             ///< pixels per inch on paper; 0: not written
    std::string description{}; ///< what made the picture, in one line; empty: not written
};

/// Reads any image that OpenImageIO can read, converted to 8 bits per channel; of more than 4
/// channels it takes the first 4. Linear light of floating-point files (EXR, HDR) is converted to
/// sRGB. Throws FileError, also for more than 2^28 pixels.
LINEATLAS_API Image read_image(const std::filesystem::path& path);

/// Writes a picture by OpenImageIO, in the format of the extension. The file appears whole or not
/// at all: it is written under another name in the same folder and renamed. In formats without
/// alpha (JPEG) the picture lies over white. EXR and HDR get linear light with colour multiplied by
/// alpha, as these formats expect. Throws FileError.
LINEATLAS_API void write_image(const std::filesystem::path& path, const Pixels& pixels,
                               const ImageSettings& settings = {});
/// The same for 8-bit pixels whose colour is not multiplied by alpha.
LINEATLAS_API void write_image(const std::filesystem::path& path, const Image& image);

/// Throws FileError unless a picture could be written to `path`: the extension is known, and the
/// folder exists and is writable. Call it before long work, so that the work is not lost.
LINEATLAS_API void check_image_path(const std::filesystem::path& path);

/// Throws FileError unless pictures of this extension can have these settings and, if asked for,
/// transparency.
LINEATLAS_API void check_image_settings(const std::filesystem::path& path,
                                        const ImageSettings& settings, bool transparent);

} // namespace lineatlas
