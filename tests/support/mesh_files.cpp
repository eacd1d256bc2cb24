#include "mesh_files.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <sstream>

namespace lineatlas::test {
namespace {

std::string text_of(double number) {
    char digits[64];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

/// A coordinate as text; the first one may be a lie.
std::string coordinate(const Model& model, std::size_t point, std::size_t axis, const Lies& lies) {
    const bool lie = point == 0 && axis == 0 && !lies.coordinate.empty();
    return lie ? lies.coordinate : text_of(model.points[point][axis]);
}
std::string index(const Model& model, std::size_t face, std::size_t corner, const Lies& lies,
                  long long first = 0) {
    const bool lie = face == 0 && corner == 0 && !lies.index.empty();
    return lie ? lies.index : std::to_string(model.faces[face][corner] + first);
}
std::string count(std::size_t truth, const std::string& lie) {
    return lie.empty() ? std::to_string(truth) : lie;
}

std::string point_lines(const Model& model, const Lies& lies, const std::string& before) {
    std::string text;
    for (std::size_t i = 0; i < model.points.size(); ++i) {
        text += before;
        for (std::size_t axis = 0; axis < 3; ++axis)
            text += coordinate(model, i, axis, lies) + (axis < 2 ? " " : "\n");
    }
    return text;
}

std::string face_lines(const Model& model, const Lies& lies) {
    std::string text;
    for (std::size_t i = 0; i < model.faces.size(); ++i) {
        text += std::to_string(model.faces[i].size());
        for (std::size_t k = 0; k < model.faces[i].size(); ++k)
            text += ' ' + index(model, i, k, lies);
        text += '\n';
    }
    return text;
}

std::string obj(const Model& model, const Lies& lies) {
    std::string text = point_lines(model, lies, "v ");
    for (std::size_t i = 0; i < model.faces.size(); ++i) {
        text += 'f';
        for (std::size_t k = 0; k < model.faces[i].size(); ++k)
            text += ' ' + index(model, i, k, lies, 1);
        text += '\n';
    }
    return text;
}

std::string off(const Model& model, const Lies& lies) {
    return "OFF\n" + count(model.points.size(), lies.vertices) + ' ' +
           count(model.faces.size(), lies.faces) + " 0\n" + point_lines(model, lies, "") +
           face_lines(model, lies);
}

/// The bytes of numbers, in either byte order.
class Bytes {
  public:
    explicit Bytes(bool big_endian = false) : big_endian_(big_endian) {}

    template <class T>
    void add(T value) {
        const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if (big_endian_)
            text.append(raw.rbegin(), raw.rend());
        else
            text.append(raw.begin(), raw.end());
    }

    std::string text;

  private:
    bool big_endian_;
};

double number(const std::string& text) {
    return std::strtod(text.c_str(), nullptr);
}
/// Too large numbers wrap around, as in files that were written by mistake.
std::uint32_t whole(const std::string& text) {
    return static_cast<std::uint32_t>(std::strtoll(text.c_str(), nullptr, 10));
}

std::string ply_header(const Model& model, const Lies& lies, const std::string& format,
                       const std::string& number) {
    std::ostringstream text;
    text << "ply\nformat " << format << " 1.0\nelement vertex "
         << count(model.points.size(), lies.vertices);
    for (const char axis : {'x', 'y', 'z'}) text << "\nproperty " << number << ' ' << axis;
    text << "\nelement face " << count(model.faces.size(), lies.faces)
         << "\nproperty list uchar int vertex_indices\nend_header\n";
    return text.str();
}

std::string ply_text(const Model& model, const Lies& lies) {
    return ply_header(model, lies, "ascii", "double") + point_lines(model, lies, "") +
           face_lines(model, lies);
}

template <class Number, bool big_endian>
std::string ply_binary(const Model& model, const Lies& lies) {
    Bytes bytes{big_endian};
    for (std::size_t i = 0; i < model.points.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            bytes.add(static_cast<Number>(number(coordinate(model, i, axis, lies))));
    for (std::size_t i = 0; i < model.faces.size(); ++i) {
        bytes.add(static_cast<std::uint8_t>(model.faces[i].size()));
        for (std::size_t k = 0; k < model.faces[i].size(); ++k)
            bytes.add(whole(index(model, i, k, lies)));
    }
    return ply_header(model, lies, big_endian ? "binary_big_endian" : "binary_little_endian",
                      sizeof(Number) == 8 ? "double" : "float") +
           bytes.text;
}

std::size_t corner(const Model& model, std::size_t face, std::size_t place) {
    return static_cast<std::size_t>(model.faces[face][place]);
}

std::string stl_text(const Model& given, const Lies& lies) {
    const Model model = triangles_of(given);
    std::string text = "solid a\n";
    for (std::size_t i = 0; i < model.faces.size(); ++i) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (std::size_t k = 0; k < 3; ++k) {
            text += "vertex";
            for (std::size_t axis = 0; axis < 3; ++axis)
                text += ' ' + coordinate(model, corner(model, i, k), axis, lies);
            text += '\n';
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid a\n";
}

std::string stl_binary(const Model& given, const Lies& lies) {
    const Model model = triangles_of(given);
    Bytes bytes;
    bytes.text.assign(80, ' ');
    bytes.add(whole(count(model.faces.size(), lies.faces)));
    for (std::size_t i = 0; i < model.faces.size(); ++i) {
        for (int k = 0; k < 3; ++k) bytes.add(0.0F);
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t axis = 0; axis < 3; ++axis)
                bytes.add(
                    static_cast<float>(number(coordinate(model, corner(model, i, k), axis, lies))));
        bytes.add(std::uint16_t{0});
    }
    return bytes.text;
}

/// Version 1.2, which lists the corners of each face.
std::string om(const Model& given, const Lies& lies) {
    const Model model = triangles_of(given);
    Bytes bytes;
    bytes.text = "OMT\x22";
    bytes.add(whole(count(model.points.size(), lies.vertices)));
    bytes.add(whole(count(model.faces.size(), lies.faces)));
    bytes.add(static_cast<std::uint32_t>(model.faces.size() * 3 / 2));
    bytes.text += std::string("\x00\x16", 2); // vertex, position, three floats
    for (std::size_t i = 0; i < model.points.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            bytes.add(static_cast<float>(number(coordinate(model, i, axis, lies))));
    bytes.text += "\xE8\x80"; // face, topology, 32 bits
    for (std::size_t i = 0; i < model.faces.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) bytes.add(whole(index(model, i, k, lies)));
    return bytes.text;
}

/// Adds a box between two corners.
void add_box(Model& model, std::array<double, 3> low, std::array<double, 3> high) {
    const auto first = static_cast<long long>(model.points.size());
    for (unsigned i = 0; i < 8; ++i)
        model.points.push_back({(i & 4U) != 0 ? high[0] : low[0], (i & 2U) != 0 ? high[1] : low[1],
                                (i & 1U) != 0 ? high[2] : low[2]});
    for (std::vector<long long> face : {std::vector<long long>{0, 1, 3, 2},
                                        {4, 6, 7, 5},
                                        {0, 4, 5, 1},
                                        {2, 3, 7, 6},
                                        {0, 2, 6, 4},
                                        {1, 5, 7, 3}}) {
        for (long long& index : face) index += first;
        model.faces.push_back(std::move(face));
    }
}

} // namespace

Model Model::moved(double scale, std::array<double, 3> origin) const {
    Model result = *this;
    for (auto& point : result.points)
        for (std::size_t axis = 0; axis < 3; ++axis)
            point[axis] = origin[axis] + scale * point[axis];
    return result;
}

Model block_on_cube() {
    Model model;
    add_box(model, {0, 0, 0}, {1, 1, 1});
    add_box(model, {0.375, 1, 0.375}, {0.625, 1.125, 0.625});
    return model;
}

Model triangles_of(const Model& model) {
    Model result{model.points, {}};
    for (const auto& face : model.faces)
        for (std::size_t i = 2; i < face.size(); ++i)
            result.faces.push_back({face[0], face[i - 1], face[i]});
    return result;
}

std::vector<MeshType> mesh_types() {
    return {{"obj", ".obj", false, false, true, obj},
            {"off", ".off", false, true, true, off},
            {"ply_text", ".ply", false, true, true, ply_text},
            {"ply_little", ".ply", true, true, false, ply_binary<float, false>},
            {"ply_big", ".ply", true, true, false, ply_binary<float, true>},
            {"ply_double", ".ply", true, true, true, ply_binary<double, false>},
            {"stl_text", ".stl", false, false, true, stl_text},
            {"stl_binary", ".stl", true, true, false, stl_binary},
            {"om", ".om", true, true, false, om}};
}

} // namespace lineatlas::test
