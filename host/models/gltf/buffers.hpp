#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "document.hpp"
#include "io/model_module.hpp"

namespace lineatlas::gltf {

/// The bytes that accessors read: those of the file itself, of files beside it, of data URIs, and
/// of views compressed by EXT_meshopt_compression. Each view is decoded once.
class Buffers {
  public:
    Buffers(const Document& document, const models::Request& request)
        : document_(document), request_(request) {}

    struct View {
        std::string_view bytes;
        std::uint64_t stride = 0; ///< 0: elements follow each other
    };
    /// The bytes of a view. Refuses a view that is not within its buffer.
    View view(std::uint64_t index);

  private:
    std::string_view buffer(std::uint64_t index);
    std::string_view find_bytes(std::uint64_t index, const Json& buffer);
    std::string decode_meshopt(const Json& extension, const std::string& of);
    std::string_view part(std::uint64_t buffer, std::uint64_t offset, std::uint64_t length,
                          const std::string& of);

    const Document& document_;
    const models::Request& request_;
    std::map<std::uint64_t, std::string_view> buffers_;
    std::map<std::uint64_t, std::string> decoded_buffers_, decoded_views_;
};

} // namespace lineatlas::gltf
