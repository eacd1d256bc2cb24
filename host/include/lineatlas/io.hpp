#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/image.hpp"
#include "lineatlas/mesh.hpp"
#include "lineatlas/progress.hpp"

namespace lineatlas {

/// A part of a model that has any: a node of a glTF scene, an instance in an assembly.
struct ModelPart {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< there is none
    std::string name;            ///< as in the file, or what it is called there for want of one
    std::uint32_t parent = none; ///< index of the part that it is in, before its own; none: of none
    /// Its number in Mesh::triangle_object and Mesh::polyline_object; none: it only holds others.
    std::uint32_t object = none;
    std::uint32_t shape = none; ///< the same for instances of the same shape
};

/// A mesh from a file, with what was repaired or dropped on the way.
struct LoadedMesh {
    Mesh mesh; ///< what the file holds; indices are in range, positions finite
    std::vector<std::string>
        notes; ///< one line each, e.g. "12 faces with fewer than 3 corners dropped"
    /// What was taken off every position: zero, unless the model lies so far from zero, compared
    /// with its size, that floats there could not hold it.
    glm::dvec3 origin{0};
    std::string format{};           ///< "glTF 2.0", "STEP AP214", "OBJ"
    std::optional<glm::vec3> up{};  ///< the upward axis, where the format or the file says it
    std::optional<double> unit{};   ///< millimetres in one unit of length, where it is said
    std::vector<ModelPart> parts{}; ///< a tree in the order of the file; empty where it has none
    /// Of STEP, IGES and BREP: LoadOptions::deflection, as it was given or found; else 0.
    double deflection = 0;
};

/// How models are read.
struct LoadOptions {
    /// Of STEP, IGES and BREP: how far a triangle's side may be off a curved face, in millimetres
    /// or the file's unit if it says none; 0: a quarter of one of `pixels`.
    double deflection = 0;
    /// Over how many pixels the diagonal of such a model is drawn, 1 to 1e6. As it stands, that of
    /// a picture of 1024 x 768.
    double pixels = 1280;
    /// Of STEP, IGES and BREP, which a process of its own reads: how much memory that may take, in
    /// GiB; 0: 2 and 32 times the file's size.
    double read_memory = 0;
    double read_seconds = 0; ///< and how much time; 0: 60 and one for each MB of the file
};

/// Reads OBJ (groups, materials and `l` elements included), PLY, STL, OFF and OM, and by modules
/// that are loaded when they are needed glTF and GLB, 3MF, STEP, IGES and BREP; chosen by extension
/// in any case. Throws FileError, one line that names the file and the cause, when the
/// file is missing, empty, truncated, of another type than its name says, refers to vertices it
/// does not have, or holds no triangle and no polyline. May be called from several threads.
///
/// STEP, IGES and BREP are read by Open CASCADE, which crashes on many a damaged file: by a
/// confined process of its own, the program `lineatlas-reader` beside the module, which ends with
/// the call. A crash, too much memory or time are a FileError, too.
///
/// Polygons are triangulated, concave ones included. Positions are as in the file, less
/// LoadedMesh::origin; only STL, which has no indices, comes welded at equal positions. Faces with
/// coordinates that are no finite numbers or beyond 1e15 are dropped. A group is one pair of object
/// and material in an OBJ file, its object named `o`, `g`, or `o/g` where both are given; its
/// colour comes from the .mtl file when that is there, and a note says when it is not. Files that
/// name nothing, and the other mesh types, have no groups. Instances in scenes and assemblies
/// become triangles of their own, with a group for each of them and its materials.
///
/// Throws Cancelled where `progress` says so; of OBJ files it is asked all along, of others when
/// the file is in memory and when it is understood.
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
    int bits = 0;              ///< per channel; 0: what its type usually has (EXR 16, others 8)
    float dpi = 0;             ///< pixels per inch on paper; 0: not said
    std::string description{}; ///< what made the picture, in one line; empty: not said
};

/// Reads any image OpenImageIO can, converted to 8 bits per channel; of more than 4 channels the
/// first 4. Files of floats (EXR, HDR) hold linear light, which is sRGB-coded on the way. Throws
/// FileError, also for more than 2^28 pixels.
LINEATLAS_API Image read_image(const std::filesystem::path& path);

/// Writes a picture through OpenImageIO, format by extension. The file appears whole or not at all:
/// it is written beside its place under another name and renamed. Formats without alpha (JPEG) get
/// the picture over white; EXR and HDR get linear light with colour multiplied by alpha, as they
/// expect. Throws FileError.
LINEATLAS_API void write_image(const std::filesystem::path& path, const Pixels& pixels,
                               const ImageSettings& settings = {});
/// The same for 8-bit pixels whose colour is not multiplied by alpha.
LINEATLAS_API void write_image(const std::filesystem::path& path, const Image& image);

/// Throws FileError unless a picture could be written at `path`: known extension, folder exists and
/// is writable. Called before long work, so that it is not lost.
LINEATLAS_API void check_image_path(const std::filesystem::path& path);

/// Throws FileError unless pictures of this extension can have such settings, and transparency.
LINEATLAS_API void check_image_settings(const std::filesystem::path& path,
                                        const ImageSettings& settings, bool transparent);

} // namespace lineatlas
