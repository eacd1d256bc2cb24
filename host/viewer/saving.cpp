#include "saving.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/path_options.hpp"
#include "apps/picture_output.hpp"
#include "apps/vector_output.hpp"
#include "io/atomic_file.hpp"
#include "settings.hpp"
#include "style/settings.hpp"

namespace lineatlas::viewer {
namespace {

std::string word(const std::string& text) {
    return text.find_first_of(" \t\"'[],#") == std::string::npos ? text : "'" + text + "'";
}

std::string lines_argument(LineKindMask lines) {
    std::string names;
    for (std::size_t kind = 0; kind < line_kind_names.size(); ++kind) {
        if ((lines >> kind & 1U) == 0) continue;
        names += (names.empty() ? "" : ",") + std::string{line_kind_names.at(kind)};
    }
    return names;
}

/// Every setting that is not what it is without any option.
std::string style_arguments(const Style& style) {
    const Style plain;
    std::string text;
    for (const Setting& setting : lineatlas::settings()) {
        const SettingValue value = setting.get(style);
        if (value == setting.get(plain)) continue;
        text += fmt::format(" --set {}", word(setting.key + "=" + value_to_toml(value)));
    }
    return text;
}

/// Paths end where the depth buffer has it, so the tool gives them a finer one.
int depth_scale_of_paths(const SavedPicture& picture) {
    constexpr int largest = 4096, finest = 4;
    const bool high = picture.options.depth_scale >= 2;
    const bool finer = picture.size.x <= largest && picture.size.y <= largest;
    return high && finer ? finest : picture.options.depth_scale;
}

void save_paths(const SavedPicture& picture, const Camera& camera,
                const std::filesystem::path& path, Renderer& renderer) {
    FrameOptions options = picture.options;
    options.method = Method::atlas; // the only one that knows intervals
    options.depth_scale = depth_scale_of_paths(picture);
    apps::VectorFrame frame;
    frame.options = options;
    frame.paths.mesh = &picture.model.mesh;
    frame.svg.title = std::filesystem::path{picture.model.source.name()}.stem().string();
    frame.json.origin = picture.model.origin;
    frame.description = command_of(picture);
    apps::VectorOutput output{std::move(frame), picture.model.lines, renderer};
    output.draw(camera, path);
    output.finish();
}

void save_pixels(const SavedPicture& picture, const Camera& camera,
                 const std::filesystem::path& path, Renderer& renderer, ImageWriter& writer) {
    check_image_path(path);
    ImageSettings settings;
    settings.description = command_of(picture);
    apps::PictureOutput output{
        {.size = picture.size, .options = picture.options, .settings = settings}, renderer, writer};
    output.draw(camera, path);
    output.finish();
}

} // namespace

std::string command_of(const SavedPicture& picture) {
    const FrameOptions& options = picture.options;
    const ModelSource& source = picture.model.source;
    std::string text =
        source.file.empty() ? "draw --scene " + source.scene : "draw " + word(source.name());
    text += fmt::format(" --method {} --probes {} --depth-scale {} --step {:g} --size {}x{}",
                        name_of(options.method).name, options.probes, options.depth_scale,
                        options.step, picture.size.x, picture.size.y);
    if (options.lines != all_line_kinds) text += " --lines " + lines_argument(options.lines);
    return text + style_arguments(options.style);
}

void save(const SavedPicture& picture, const std::filesystem::path& path, Renderer& renderer,
          ImageWriter& writer) {
    SavedPicture still = picture;
    still.options.steady = false; // nothing of the frames before
    const Camera camera = make_camera(picture.view, picture.size, picture.model.lines.bounds);
    if (apps::is_path_file(path))
        save_paths(still, camera, path, renderer);
    else
        save_pixels(still, camera, path, renderer, writer);
}

std::string camera_file(const View& view, glm::dvec3 origin) {
    const auto vector = [](glm::vec3 v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
    const auto point = [&](glm::vec3 v) {
        if (origin == glm::dvec3{0}) return vector(v); // with no more digits than a float has
        const glm::dvec3 at = origin + glm::dvec3{v};
        return nlohmann::ordered_json{at.x, at.y, at.z};
    };
    const double degrees = static_cast<double>(view.fov_y) * 180 / std::numbers::pi;
    const nlohmann::ordered_json key{{"frame", 0},
                                     {"eye", point(view.eye)},
                                     {"target", point(view.target)},
                                     {"up", vector(view.up)},
                                     {"fov", degrees}};
    return nlohmann::ordered_json{{"keys", {key}}}.dump(2) + "\n";
}

void save_text(const std::string& text, const std::filesystem::path& path) {
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

std::filesystem::path free_path(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& extension) {
    std::filesystem::path path = folder / fmt::format("{}.{}", stem, extension);
    for (int number = 2; std::filesystem::exists(path); ++number) {
        path = folder / fmt::format("{}-{}.{}", stem, number, extension);
    }
    return path;
}

} // namespace lineatlas::viewer
