#include "document.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace lineatlas::gltf {

namespace {

constexpr std::string_view binary_mark = "glTF";

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return value;
}

/// The chunks of a GLB file: JSON first, then the bytes of its buffer, if there are any.
struct Chunks {
    std::string_view json, binary;
};

Chunks chunks_of(std::string_view file) {
    constexpr std::size_t header = 12, chunk_header = 8;
    constexpr std::uint32_t json_type = 0x4E4F534AU, binary_type = 0x004E4942U;
    if (file.size() < header + chunk_header) refuse("it ends within its header");
    const std::uint32_t version = little_endian(file, 4), length = little_endian(file, 8);
    if (version != 2) refuse("it is glTF " + std::to_string(version) + "; only glTF 2.0 is read");
    if (length > file.size())
        refuse("it has " + std::to_string(file.size()) + " bytes of " + std::to_string(length));
    Chunks chunks;
    file = file.substr(0, length);
    for (std::size_t at = header; at < file.size();) {
        if (file.size() - at < chunk_header) refuse("it ends within a chunk's header");
        const std::uint32_t size = little_endian(file, at), type = little_endian(file, at + 4);
        at += chunk_header;
        if (size > file.size() - at) refuse("a chunk of it is longer than the file");
        if (at == header + chunk_header && type != json_type) refuse("its first chunk is no JSON");
        if (type == json_type && chunks.json.empty()) chunks.json = file.substr(at, size);
        if (type == binary_type && chunks.binary.empty()) chunks.binary = file.substr(at, size);
        at += size;
    }
    return chunks;
}

Json parse(std::string_view text) {
    // glTF needs about ten levels. Endlessly nested lists would overflow the stack, and are refused
    // before anything is built.
    constexpr int most_levels = 64;
    int deepest = 0, level = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            in_string = c != '"';
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{' || c == '[') {
            deepest = std::max(deepest, ++level);
        } else if (c == '}' || c == ']') {
            --level;
        }
    }
    if (deepest > most_levels) refuse("its JSON is nested more than 64 deep");
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        refuse("it is no JSON; parsing stops at byte " + std::to_string(error.byte));
    } catch (const Json::exception&) {
        refuse("its JSON has a number that cannot be held");
    }
}

/// The extensions that place geometry and are supported.
constexpr std::array heeded{"EXT_mesh_gpu_instancing", "EXT_meshopt_compression",
                            "KHR_draco_mesh_compression", "KHR_mesh_quantization",
                            "KHR_node_visibility"};

/// Prefixes of extensions that do not move geometry. They are about materials, formats of pictures,
/// lights, and data of parts.
constexpr std::array moving_nothing{"ADOBE_materials_",
                                    "EXT_instance_features",
                                    "EXT_lights_",
                                    "EXT_materials_",
                                    "EXT_mesh_features",
                                    "EXT_structural_metadata",
                                    "EXT_texture_",
                                    "KHR_animation_pointer",
                                    "KHR_audio",
                                    "KHR_interactivity",
                                    "KHR_lights_",
                                    "KHR_materials_",
                                    "KHR_node_hoverability",
                                    "KHR_node_selectability",
                                    "KHR_texture_",
                                    "KHR_xmp",
                                    "MSFT_packing_",
                                    "MSFT_texture_"};

bool can_be_drawn(std::string_view extension) {
    return std::ranges::find(heeded, extension) != heeded.end() ||
           std::ranges::any_of(moving_nothing, [&](std::string_view begin) {
               return extension.starts_with(begin);
           });
}

void check_extensions(const Json& json) {
    const Json* required = find(json, "extensionsRequired");
    if (required == nullptr) return;
    if (!required->is_array()) refuse("\"extensionsRequired\" is no list");
    for (const Json& name : *required) {
        if (!name.is_string()) refuse("\"extensionsRequired\" must be a list of names");
        const auto& extension = name.get_ref<const std::string&>();
        if (!can_be_drawn(extension))
            refuse("it requires the extension " + extension.substr(0, 60) +
                   ", which is not supported");
    }
}

} // namespace

void refuse(const std::string& cause) {
    throw std::runtime_error(cause);
}

std::string numbered(std::string_view what, std::uint64_t number) {
    return std::string(what) + ' ' + std::to_string(number);
}

Document open_document(std::string_view file) {
    Document document;
    if (file.starts_with(binary_mark)) {
        const Chunks chunks = chunks_of(file);
        document = {.json = parse(chunks.json), .binary = chunks.binary};
    } else {
        document.json = parse(file);
    }
    if (!document.json.is_object()) refuse("its JSON is no object");
    const Json* asset = find_object(document.json, "asset", "the file");
    if (asset == nullptr) refuse("it is JSON, but no glTF: it has no \"asset\"");
    const std::string version = text(*asset, "version", "");
    if (!version.starts_with("2."))
        refuse("it is glTF \"" + version.substr(0, 20) + "\"; only glTF 2.0 is read");
    check_extensions(document.json);
    return document;
}

const Json* find(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

const Json* find_object(const Json& object, const char* key, const std::string& of) {
    const Json* found = find(object, key);
    if (found != nullptr && !found->is_object())
        refuse(std::string{"\""} + key + "\" of " + of + " is no object");
    return found;
}

const Json& element(const Document& document, const char* list, std::uint64_t index) {
    const std::uint64_t size = count(document, list);
    if (index >= size)
        refuse("it refers to number " + std::to_string(index) + " of its \"" + list +
               "\", which are " + std::to_string(size));
    const Json& found = document.json[list][index];
    if (!found.is_object())
        refuse("number " + std::to_string(index) + " of its \"" + list + "\" is no object");
    return found;
}

std::uint64_t count(const Document& document, const char* list) {
    const Json* found = find(document.json, list);
    if (found == nullptr) return 0;
    if (!found->is_array()) refuse("its \"" + std::string(list) + "\" are no list");
    return found->size();
}

std::uint64_t whole(const Json& value, const std::string& of) {
    // Some writers put 5.0 for 5.
    constexpr double most = 9e15;
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (number >= 0 && number <= most &&
            number == static_cast<double>(static_cast<std::uint64_t>(number)))
            return static_cast<std::uint64_t>(number);
    }
    refuse("a count or index of " + of + " is no whole number");
}

std::uint64_t whole(const Json& object, const char* key, const std::string& of) {
    const Json* found = find(object, key);
    if (found == nullptr) refuse(of + " has no \"" + key + "\"");
    return whole(*found, std::string{"\""} + key + "\" of " + of);
}

std::uint64_t whole(const Json& object, const char* key, const std::string& of,
                    std::uint64_t otherwise) {
    return find(object, key) == nullptr ? otherwise : whole(object, key, of);
}

std::string text(const Json& object, const char* key, std::string_view otherwise) {
    const Json* found = find(object, key);
    return found != nullptr && found->is_string() ? found->get<std::string>()
                                                  : std::string(otherwise);
}

double number(const Json& value, const std::string& of) {
    if (!value.is_number()) refuse("a list of " + of + " must hold numbers alone");
    return value.get<double>();
}

} // namespace lineatlas::gltf
