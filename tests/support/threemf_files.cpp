#include "threemf_files.hpp"

#include <array>
#include <cstdint>
#include <stdexcept>

#include <zlib.h>

namespace lineatlas::test {

namespace {

class Bytes {
  public:
    Bytes& two(std::size_t value) { return add(value, 2); }
    Bytes& four(std::size_t value) { return add(value, 4); }
    Bytes& text(std::string_view text) {
        bytes_ += text;
        return *this;
    }
    const std::string& get() const { return bytes_; }

  private:
    Bytes& add(std::size_t value, int count) {
        for (; count > 0; --count, value >>= 8U) bytes_ += static_cast<char>(value & 0xFFU);
        return *this;
    }
    std::string bytes_;
};

std::string packed(const std::string& bytes) {
    z_stream stream{};
    constexpr int without_header = -15, memory = 8;
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, without_header, memory,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::runtime_error("zlib does not start");
    std::string result(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    const int outcome = deflate(&stream, Z_FINISH);
    result.resize(stream.total_out);
    deflateEnd(&stream);
    if (outcome != Z_STREAM_END) throw std::runtime_error("zlib does not end");
    return result;
}

std::string archive(const std::vector<ZipPart>& parts, bool pack) {
    constexpr std::size_t version = 20, deflated = 8;
    Bytes files, directory;
    for (const ZipPart& part : parts) {
        const auto sum = crc32(0, reinterpret_cast<const Bytef*>(part.bytes.data()),
                               static_cast<uInt>(part.bytes.size()));
        const std::string content = pack ? packed(part.bytes) : part.bytes;
        const std::size_t begin = files.get().size();
        const auto describe = [&](Bytes& to) {
            to.two(version).two(0).two(pack ? deflated : 0).two(0).two(33); // 1 January 1980
            to.four(sum).four(content.size()).four(part.bytes.size());
            to.two(part.name.size()).two(0);
        };
        files.text("PK\3\4");
        describe(files);
        files.text(part.name).text(content);
        directory.text("PK\1\2").two(version);
        describe(directory);
        directory.two(0).two(0).two(0).four(0).four(begin).text(part.name);
    }
    Bytes end;
    end.text("PK\5\6").two(0).two(0).two(parts.size()).two(parts.size());
    end.four(directory.get().size()).four(files.get().size()).two(0);
    return files.get() + directory.get() + end.get();
}

} // namespace

std::string to_zip(const std::vector<ZipPart>& parts) {
    return archive(parts, false);
}

std::string to_packed_zip(const std::vector<ZipPart>& parts) {
    return archive(parts, true);
}

std::vector<ZipPart> package_parts() {
    return {{"[Content_Types].xml",
             R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>)"},
            {"_rels/.rels",
             R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>)"}};
}

std::string to_3mf(const std::string& model) {
    std::vector<ZipPart> parts = package_parts();
    parts.push_back({"3D/3dmodel.model", model});
    return to_zip(parts);
}

std::string threemf_model(std::string_view resources, std::string_view items,
                          std::string_view attributes) {
    std::string model = R"(<?xml version="1.0" encoding="UTF-8"?>
<model xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
 xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02" )";
    model.append(attributes).append("><resources>").append(resources);
    return model.append("</resources><build>").append(items).append("</build></model>");
}

std::string cube_object(int id, std::string_view name, std::string_view attributes,
                        std::string_view triangle_attributes) {
    std::string object = "<object id=\"" + std::to_string(id) + "\" type=\"model\" name=\"";
    object.append(name).append("\" ").append(attributes).append("><mesh><vertices>");
    for (unsigned i = 0; i < 8; ++i) {
        object += "<vertex x=\"" + std::to_string(i & 1U) + "\" y=\"" +
                  std::to_string(i >> 1U & 1U) + "\" z=\"" + std::to_string(i >> 2U) + "\"/>";
    }
    object += "</vertices><triangles>";
    constexpr std::array<std::array<int, 3>, 12> triangles{{{0, 2, 1},
                                                            {1, 2, 3},
                                                            {4, 5, 6},
                                                            {5, 7, 6},
                                                            {0, 1, 4},
                                                            {1, 5, 4},
                                                            {2, 6, 3},
                                                            {3, 6, 7},
                                                            {0, 4, 2},
                                                            {2, 4, 6},
                                                            {1, 3, 5},
                                                            {3, 7, 5}}};
    for (const auto& [a, b, c] : triangles) {
        object += "<triangle v1=\"" + std::to_string(a) + "\" v2=\"" + std::to_string(b) +
                  "\" v3=\"" + std::to_string(c) + "\" ";
        object.append(triangle_attributes).append("/>");
    }
    return object += "</triangles></mesh></object>";
}

} // namespace lineatlas::test
