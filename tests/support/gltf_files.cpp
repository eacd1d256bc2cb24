#include "gltf_files.hpp"

namespace lineatlas::test {

namespace {

std::string little_endian(std::uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
    return bytes;
}

} // namespace

std::string to_glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    std::string chunks = little_endian(static_cast<std::uint32_t>(json.size())) + "JSON" + json;
    if (!binary.empty())
        chunks += little_endian(static_cast<std::uint32_t>(binary.size())) +
                  std::string("BIN\0", 4) + binary;
    return "glTF" + little_endian(2) +
           little_endian(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

std::string to_data_uri(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text = "data:application/octet-stream;base64,";
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits =
                bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 0x3FU];
    }
    return text;
}

std::vector<float> cube_corners() {
    std::vector<float> numbers;
    for (int i = 0; i < 8; ++i)
        for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<float>(i >> axis & 1));
    return numbers;
}

std::vector<std::uint16_t> cube_triangles() {
    return {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
            2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
}

std::string cube_bytes() {
    return GltfBytes{}.add(cube_corners()).add(cube_triangles()).bytes();
}

std::string cube_json(const std::string& nodes, const std::string& uri,
                      const std::string& members) {
    const std::string named = uri.empty() ? "" : R"(,"uri":")" + uri + '"';
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
           R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":96},)"
           R"({"buffer":0,"byteOffset":96,"byteLength":72}],)"
           R"("buffers":[{"byteLength":168)" +
           named + "}]" + members + '}';
}

} // namespace lineatlas::test
