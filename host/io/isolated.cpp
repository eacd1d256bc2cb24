#include "isolated.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <utility>

#include "image_codec.hpp"
#include "image_loader.hpp"
#include "mesh_source.hpp"
#include "reader_messages.hpp"
#include "reader_protocol.hpp"

namespace lineatlas {

namespace {

constexpr std::string_view mesh_kind = "mesh";
constexpr std::string_view image_kind = "image";

ReaderKind::Parse open_mesh(const std::filesystem::path& path, std::string_view settings) {
    LoadOptions options;
    const char* const end = settings.data() + settings.size();
    const auto deflection = std::from_chars(settings.data(), end, options.deflection);
    if (deflection.ptr != end) std::from_chars(deflection.ptr + 1, end, options.pixels);
    return [source = read_mesh_source(path), options](ReaderOutput& output) mutable {
        send(output, parse_mesh(std::move(source), options));
    };
}

ReaderKind::Parse open_picture(const std::filesystem::path& path, std::string_view) {
    SourceFile file = read_source(path);
    image_module(type_by_content(file.bytes)); // nothing can be loaded later
    return [file = std::move(file)](ReaderOutput& output) { send(output, decode_image(file)); };
}

constexpr std::array kinds{ReaderKind{mesh_kind, open_mesh}, ReaderKind{image_kind, open_picture}};

} // namespace

ReadLimits limits_for_picture(const ReadLimits& limits) {
    // Memory for a picture of 4096 x 4096 floats. The size of the file says nothing: a small file
    // may unpack to far more, and a large one need not be a picture.
    constexpr std::uint64_t usual_memory = std::uint64_t{512} << 20U;
    constexpr std::chrono::seconds usual_time{60};
    ReadLimits filled = limits;
    if (filled.memory == 0) filled.memory = usual_memory;
    if (filled.time.count() == 0) filled.time = usual_time;
    return filled;
}

std::optional<int> serve_as_reader(int argc, char** argv) {
    return serve_as_reader(argc, argv, kinds);
}

LoadedMesh load_mesh_isolated(const std::filesystem::path& path, const ReadLimits& limits,
                              const LoadOptions& options) {
    return serves_as_reader() ? load_mesh_by({}, path, limits, options) : load_mesh(path, options);
}

LoadedMesh load_mesh_by(const std::filesystem::path& program, const std::filesystem::path& path,
                        const ReadLimits& limits, const LoadOptions& options) {
    // As text, in which %.17g keeps numbers exactly.
    std::array<char, 64> settings{};
    std::snprintf(settings.data(), settings.size(), "%.17g %.17g", options.deflection,
                  options.pixels);
    ReaderProcess process{mesh_kind, path, limits, settings.data(), program};
    return receive_model(process);
}

Image read_image_isolated(const std::filesystem::path& path, const ReadLimits& limits) {
    if (!serves_as_reader()) return read_image(path);
    ReaderProcess process{image_kind, path, limits_for_picture(limits)};
    return receive_picture(process);
}

} // namespace lineatlas
