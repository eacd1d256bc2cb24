#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "extension.hpp"
#include "gltf_files.hpp"
#include "isolated.hpp"
#include "mesh_readers.hpp"
#include "mesh_source.hpp"
#include "model_loader.hpp"
#include "model_types.hpp"
#include "own_readers.hpp"
#include "soup.hpp"

namespace lineatlas {

namespace {

/// ".obj" as "OBJ"
std::string upper_name(std::string_view extension) {
    std::string name(extension.substr(1));
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name;
}

Soup read_soup(MeshSource source, const std::string& extension, const LoadOptions& options,
               const ProgressPart& progress) {
    SourceFile& model = source.model;
    if (is_read_by_module(extension))
        return read_by_module(model, extension, source.named, options);
    if (find_model_type(extension)->reader != ModelReader::om)
        return read_own(std::move(model), extension, source.materials, progress);
    refuse_other_types(model, extension);
    return read_om(model);
}

/// The limits of the options. Throws UsageError for impossible ones.
ReadLimits limits_of(const LoadOptions& options) {
    const auto check = [](const char* member, double value, const char* most) {
        if (value >= 0 && value <= std::atof(most)) return; // false for NaN
        throw UsageError(std::string{member} + " must be from 0 to " + most);
    };
    check("LoadOptions::deflection", options.deflection, "1e15");
    if (!(options.pixels >= 1 && options.pixels <= 1e6))
        throw UsageError("LoadOptions::pixels must be from 1 to 1e6");
    check("LoadOptions::read_memory", options.read_memory, "1e6");
    check("LoadOptions::read_seconds", options.read_seconds, "1e6");
    constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
    return {.memory = static_cast<std::uint64_t>(std::ceil(options.read_memory * gibibyte)),
            .time = std::chrono::milliseconds{
                static_cast<std::int64_t>(std::ceil(options.read_seconds * 1000))}};
}

} // namespace

MeshSource read_mesh_source(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    const ModelType* const type = find_model_type(extension);
    MeshSource source{.model = read_source(path), .materials = {}};
    if (is_read_by_module(extension)) {
        refuse_other_types(source.model, extension);
        if (type->reader == ModelReader::gltf) source.named = read_gltf_files(source.model);
        prepare_module(extension);
        return source;
    }
    if (type == nullptr) {
        refuse_other_models(source.model, extension);
        refuse_other_types(source.model, extension);
        throw read_error(path, "unknown mesh type \"" + printable(extension) + "\"; known are " +
                                   model_extensions());
    }
    if (type->reader == ModelReader::obj) source.materials = read_material_files(source.model);
    return source;
}

LoadedMesh parse_mesh(MeshSource source, const LoadOptions& options, const ProgressPart& progress) {
    const std::filesystem::path path = source.model.path;
    try {
        const std::string extension = lower_extension(path);
        progress(0);
        Soup soup = read_soup(std::move(source), extension, options, progress.part(0, 0.7F));
        progress(0.7F);
        LoadedMesh loaded = finish(std::move(soup), path);
        if (loaded.format.empty()) loaded.format = upper_name(extension);
        return loaded;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw read_error(path, "not enough memory");
    } catch (const std::exception& error) {
        throw read_error(path, printable(error.what()));
    }
}

LoadedMesh load_mesh(const std::filesystem::path& path, const LoadOptions& options,
                     const Progress& progress) {
    const ProgressPart done{progress, "reading"};
    done(0);
    const std::string extension = lower_extension(path);
    LoadedMesh loaded;
    if (may_crash(extension)) {
        check_source(path);
        loaded =
            load_mesh_by(serves_as_reader() ? std::filesystem::path{} : reader_program(extension),
                         path, limits_of(options), options);
    } else {
        loaded = parse_mesh(read_mesh_source(path), options, done.part(0.1F, 1));
    }
    done(1);
    return loaded;
}

} // namespace lineatlas
