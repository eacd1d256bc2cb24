#include "source_file.hpp"

#include <array>

namespace lineatlas {

namespace {

struct Signature {
    std::string_view magic;
    std::string_view what;
    std::string_view extension{}; ///< extension of files that have this type on purpose
};

constexpr std::array signatures{
    Signature{"\x89PNG", "a PNG picture"},
    Signature{"\xFF\xD8\xFF", "a JPEG picture"},
    Signature{"GIF8", "a GIF picture"},
    Signature{"%PDF", "a PDF document"},
    Signature{"\x1F\x8B", "compressed by gzip; unpack it first"},
    Signature{"BZh", "compressed by bzip2; unpack it first"},
    Signature{"\xFD"
              "7zXZ",
              "compressed by xz; unpack it first"},
    Signature{"\x28\xB5\x2F\xFD", "compressed by zstd; unpack it first"},
    Signature{"7z\xBC\xAF", "a 7z archive; unpack it first"},
    Signature{"PK\x03\x04", "a ZIP archive; unpack it first", ".3mf"},
    Signature{"\x7F"
              "ELF",
              "a program"},
    Signature{"Kaydara FBX", "an FBX model; convert it to GLB, with Blender for one"},
    Signature{"<?xml", "an XML document"},
    Signature{"<!DOCTYPE", "an HTML page; was the download refused?"},
    Signature{"<html", "an HTML page; was the download refused?"},
    Signature{"version https://git-lfs", "a Git LFS pointer; run \"git lfs pull\""},
    Signature{"\xFF\xFE", "UTF-16 text; save it as UTF-8"},
    Signature{"\xFE\xFF", "UTF-16 text; save it as UTF-8"},
};

struct MeshSignature {
    std::string_view magic;
    std::string_view extension;
    std::string_view also{}; ///< another extension that such files have
};

// STL is not listed: "solid" may start any text, and a binary STL starts with anything.
constexpr std::array mesh_signatures{
    MeshSignature{"ply\n", ".ply"},         MeshSignature{"ply\r", ".ply"},
    MeshSignature{"OFF\n", ".off"},         MeshSignature{"OFF\r", ".off"},
    MeshSignature{"COFF\n", ".off"},        MeshSignature{"OMT", ".om"},
    MeshSignature{"glTF", ".glb", ".gltf"}, MeshSignature{"ISO-10303-21;", ".step", ".stp"},
};

} // namespace

std::string quoted(const std::string& path) {
    constexpr std::size_t longest = 400;
    // Of a long path the end is kept, because it has the file's name.
    const std::string text =
        path.size() <= longest ? path : "..." + path.substr(path.size() - longest);
    return '"' + printable(text, text.size()) + '"';
}

FileError read_error(const std::string& path, std::string_view cause) {
    return FileError("cannot read " + quoted(path) + ": " + std::string(cause));
}

FileError write_error(const std::string& path, std::string_view cause) {
    return FileError("cannot write " + quoted(path) + ": " + std::string(cause));
}

std::string counted(std::size_t count, std::string_view singular, std::string_view plural) {
    return std::to_string(count) + ' ' + std::string(count == 1 ? singular : plural);
}

std::string_view without_utf8_mark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

void refuse_other_types(const SourceFile& source, std::string_view extension) {
    const std::string_view bytes = source.bytes;
    for (const Signature& signature : signatures)
        if (bytes.starts_with(signature.magic) && extension != signature.extension)
            throw read_error(source.path, "it is " + std::string(signature.what));
    for (const MeshSignature& signature : mesh_signatures)
        if (bytes.starts_with(signature.magic) && extension != signature.extension &&
            extension != signature.also)
            throw read_error(source.path, "it holds a mesh of type " +
                                              std::string(signature.extension) +
                                              "; give it that extension");
}

} // namespace lineatlas
