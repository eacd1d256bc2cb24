#include "buffers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include <meshoptimizer.h>

namespace lineatlas::gltf {

namespace {

constexpr const char* meshopt = "EXT_meshopt_compression";

std::string decode_base64(std::string_view text, const std::string& of) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int held = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == digits.npos) refuse("the data URI of " + of + " is no base64");
        bits = bits << 6U | static_cast<std::uint32_t>(digit);
        held += 6;
        if (held < 8) continue;
        held -= 8;
        bytes += static_cast<char>(bits >> static_cast<unsigned>(held) & 0xFFU);
    }
    return bytes;
}

/// The bytes behind the head of a data URI.
std::string decode_data_uri(std::string_view uri, const std::string& of) {
    constexpr std::string_view coding = ";base64";
    const std::size_t comma = uri.find(',');
    if (comma == uri.npos || !uri.substr(0, comma).ends_with(coding))
        refuse("the data URI of " + of + " is not coded in base64");
    return decode_base64(uri.substr(comma + 1), of);
}

/// Undoes the filter by which values were packed better.
void unfilter(std::string& values, const std::string& filter, std::uint64_t count,
              std::uint64_t stride, const std::string& of) {
    const auto decode = [&](void (*function)(void*, std::size_t, std::size_t), bool fits) {
        if (!fits) refuse("the filter of " + of + " does not fit its stride");
        function(values.data(), count, stride);
    };
    if (filter == "NONE") return;
    if (filter == "OCTAHEDRAL") return decode(meshopt_decodeFilterOct, stride == 4 || stride == 8);
    if (filter == "QUATERNION") return decode(meshopt_decodeFilterQuat, stride == 8);
    if (filter == "EXPONENTIAL") return decode(meshopt_decodeFilterExp, stride % 4 == 0);
    refuse("the filter of " + of + " is unknown");
}

} // namespace

Buffers::View Buffers::view(std::uint64_t index) {
    const Json& json = element(document_, "bufferViews", index);
    const std::string of = numbered("buffer view", index);
    View view{.bytes = {}, .stride = whole(json, "byteStride", of, 0)};
    const Json* extensions = find_object(json, "extensions", of);
    const Json* packed = extensions != nullptr ? find_object(*extensions, meshopt, of) : nullptr;
    if (packed == nullptr) {
        view.bytes = part(whole(json, "buffer", of), whole(json, "byteOffset", of, 0),
                          whole(json, "byteLength", of), of);
        return view;
    }
    auto decoded = decoded_views_.find(index);
    if (decoded == decoded_views_.end())
        decoded = decoded_views_.emplace(index, decode_meshopt(*packed, of)).first;
    view.bytes = decoded->second;
    return view;
}

std::string_view Buffers::buffer(std::uint64_t index) {
    const auto known = buffers_.find(index);
    if (known != buffers_.end()) return known->second;
    const Json& json = element(document_, "buffers", index);
    const std::string of = numbered("buffer", index);
    const std::uint64_t length = whole(json, "byteLength", of);
    const std::string_view bytes = find_bytes(index, json);
    if (bytes.size() < length)
        refuse(of + " has " + std::to_string(bytes.size()) + " bytes of " + std::to_string(length));
    return buffers_[index] = bytes.substr(0, length);
}

std::string_view Buffers::find_bytes(std::uint64_t index, const Json& buffer) {
    const std::string of = numbered("buffer", index);
    if (find(buffer, "uri") == nullptr) {
        if (index == 0 && !document_.binary.empty()) return document_.binary;
        refuse(of + " has no content: it names no file, and no binary chunk holds it");
    }
    const std::string uri = text(buffer, "uri", "");
    if (uri.starts_with("data:")) return decoded_buffers_[index] = decode_data_uri(uri, of);
    const auto named = std::ranges::find(request_.named, uri, &models::NamedFile::name);
    if (named == request_.named.end())
        refuse(of + " is in the file \"" + uri.substr(0, 60) +
               "\", which is not beside the model or below its folder, or cannot be read");
    return named->bytes;
}

std::string_view Buffers::part(std::uint64_t index, std::uint64_t offset, std::uint64_t length,
                               const std::string& of) {
    const std::string_view bytes = buffer(index);
    if (offset > bytes.size() || length > bytes.size() - offset)
        refuse(of + " ends beyond its buffer");
    return bytes.substr(offset, length);
}

std::string Buffers::decode_meshopt(const Json& extension, const std::string& of) {
    // A limit, so that no file makes the reader allocate more than it can hold. At best 16 bytes
    // are packed into a quarter of a byte, and the three indices of a triangle into one byte.
    constexpr std::uint64_t most_per_byte = 64;
    constexpr std::uint64_t largest_stride = 256;
    const std::string_view packed =
        part(whole(extension, "buffer", of), whole(extension, "byteOffset", of, 0),
             whole(extension, "byteLength", of), of);
    const std::uint64_t count = whole(extension, "count", of);
    const std::uint64_t stride = whole(extension, "byteStride", of);
    const std::string mode = text(extension, "mode", "");
    const bool indices = mode == "TRIANGLES" || mode == "INDICES";
    if (indices ? stride != 2 && stride != 4
                : stride == 0 || stride % 4 != 0 || stride > largest_stride)
        refuse("the stride of " + of + " is not one that " + meshopt + " allows");
    if (count > packed.size() * most_per_byte / stride)
        refuse(of + " cannot hold as much as it says");

    std::string values(count * stride, '\0');
    const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
    int failure = -1;
    if (mode == "ATTRIBUTES") {
        failure = meshopt_decodeVertexBuffer(values.data(), count, stride, from, packed.size());
    } else if (mode == "TRIANGLES") {
        if (count % 3 != 0) refuse(of + " has a number of indices that makes no triangles");
        failure = meshopt_decodeIndexBuffer(values.data(), count, stride, from, packed.size());
    } else if (mode == "INDICES") {
        failure = meshopt_decodeIndexSequence(values.data(), count, stride, from, packed.size());
    }
    if (failure != 0) refuse(of + " is damaged: " + meshopt + " cannot be decoded");
    unfilter(values, text(extension, "filter", "NONE"), count, stride, of);
    return values;
}

} // namespace lineatlas::gltf
