#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace lineatlas::gltf {

using Json = nlohmann::json;

/// The contents of a file: text in JSON, and the bytes that follow it in a GLB file.
struct Document {
    Json json;
    std::string_view binary; ///< lies in the file's own bytes
};

/// Takes a .gltf or .glb file apart. Its first bytes say which it is. Refuses files that are no
/// glTF 2.0, and by name every required extension that may place geometry in an unknown way.
Document open_document(std::string_view file);

/// Throws std::runtime_error.
[[noreturn]] void refuse(const std::string& cause);

/// "mesh 3"
std::string numbered(std::string_view what, std::uint64_t number);

// Members of an object. A member of another type is refused. `of`: text that names the object.

/// A member; null if it is missing.
const Json* find(const Json& object, const char* key);
const Json* find_object(const Json& object, const char* key, const std::string& of);
/// The element `index` of the file's list `list`. Refuses an index beyond it.
const Json& element(const Document& document, const char* list, std::uint64_t index);
/// The length of a list; 0 if it is missing.
std::uint64_t count(const Document& document, const char* list);
std::uint64_t whole(const Json& object, const char* key, const std::string& of);
std::uint64_t whole(const Json& object, const char* key, const std::string& of,
                    std::uint64_t otherwise);
/// An element of a list of indices.
std::uint64_t whole(const Json& value, const std::string& of);
std::string text(const Json& object, const char* key, std::string_view otherwise);
/// Fills `numbers` and returns true. Returns false, and changes nothing, if the member is missing.
template <class Numbers>
bool read_numbers(const Json& object, const char* key, const std::string& of, Numbers& numbers);

/// One number, finite or not.
double number(const Json& value, const std::string& of);

template <class Numbers>
bool read_numbers(const Json& object, const char* key, const std::string& of, Numbers& numbers) {
    const Json* list = find(object, key);
    if (list == nullptr) return false;
    if (!list->is_array() || list->size() != numbers.size())
        refuse(std::string{"\""} + key + "\" of " + of + " is no list of " +
               std::to_string(numbers.size()) + " numbers");
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = number((*list)[i], of);
    return true;
}

} // namespace lineatlas::gltf
