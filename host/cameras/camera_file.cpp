#include "camera_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "io/source_file.hpp"
#include "lineatlas/error.hpp"
#include "style/settings.hpp"

namespace lineatlas {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

constexpr double usual_fps = 25;
constexpr double most_frames = 1e6;

// Limits of a camera path, checked before it is parsed into memory.
constexpr std::uintmax_t most_bytes = std::uintmax_t{16} << 20U;
constexpr int deepest = 8;

/// Reads one file; every message names it.
class Reader {
  public:
    explicit Reader(const std::filesystem::path& file) : file_(file) {}

    FileError error(const std::string& cause) const {
        return FileError(quoted(file_) + ": " + cause);
    }

    Json parse() const {
        if (check_source(file_) > most_bytes)
            throw error("it is larger than 16 MiB, which no camera path is");
        const auto check_depth = [&](int depth, Json::parse_event_t, const Json&) {
            if (depth > deepest) throw error(fmt::format("it is nested deeper than {}", deepest));
            return true;
        };
        try {
            return Json::parse(read_source(file_).bytes, check_depth);
        } catch (const Json::exception& failure) {
            std::string cause =
                failure.what(); // "[json.exception.parse_error.101] parse error ..."
            cause.erase(0, cause.find("] ") == std::string::npos ? 0 : cause.find("] ") + 2);
            throw error("it is not JSON: " + printable_line(cause));
        }
    }

    /// Throws unless `object` is an object with no other members than these.
    void check_members(const Json& object, const std::string& where,
                       const std::vector<std::string>& known) const {
        if (!object.is_object()) {
            throw error(where + " must be an object, as in {\"" + known.front() + "\": ...}");
        }
        for (const auto& [name, _] : object.items()) {
            if (std::ranges::find(known, name) != known.end()) continue;
            std::string way_out = suggestion(name, known);
            if (way_out.empty()) way_out = fmt::format("; there is {}", fmt::join(known, ", "));
            throw error(where + " has an unknown member \"" + printable(name) + "\"" + way_out);
        }
    }

    double number(const Json& value, const std::string& where, double low, double high) const {
        if (value.is_number()) {
            const double number = value.get<double>();
            if (number >= low && number <= high) return number;
        }
        throw error(fmt::format("{} must be a number from {} to {}, not {}", where, low, high,
                                written(value)));
    }

    glm::dvec3 vector(const Json& value, const std::string& where) const {
        glm::dvec3 result{0};
        bool good = value.is_array() && value.size() == 3;
        for (int i = 0; good && i < 3; ++i) {
            const Json& part = value[static_cast<std::size_t>(i)];
            good = part.is_number() && std::isfinite(part.get<float>());
            if (good) result[i] = part.get<double>();
        }
        if (good) return result;
        throw error(fmt::format("{} must be three finite numbers, as in [1, 2.5, -3], not {}",
                                where, written(value)));
    }

  private:
    static std::string printable_line(const std::string& text) {
        return text.substr(0, text.find_first_of("\r\n"));
    }
    static std::string written(const Json& value) {
        constexpr auto replace = Json::error_handler_t::replace;
        return printable(value.dump(-1, ' ', true, replace));
    }

    const std::filesystem::path& file_;
};

double key_frame(const Reader& reader, const Json& key, const std::string& where, double fps) {
    if (key.contains("frame") == key.contains("time")) {
        throw reader.error(where + " needs either a \"frame\" or a \"time\" in seconds");
    }
    if (key.contains("frame")) {
        return reader.number(key["frame"], where + ".frame", 0, most_frames);
    }
    return reader.number(key["time"], where + ".time", 0, most_frames / fps) * fps;
}

View key_view(const Reader& reader, const Json& key, const std::string& where, glm::dvec3 origin,
              View view) {
    view.near = view.far = 0;
    for (const auto& [name, member] :
         {std::pair{"eye", &View::eye}, std::pair{"target", &View::target}}) {
        if (!key.contains(name)) throw reader.error(fmt::format("{} needs \"{}\"", where, name));
        view.*member = reader.vector(key[name], fmt::format("{}.{}", where, name)) - origin;
    }
    if (view.eye == view.target) {
        throw reader.error(where + ": eye and target must be two different points");
    }
    if (key.contains("up")) {
        view.up = reader.vector(key["up"], where + ".up");
        if (view.up == glm::vec3{0}) throw reader.error(where + ".up must not be the zero vector");
    }
    view.up = glm::normalize(view.up);
    if (key.contains("fov")) {
        constexpr double narrowest = 0.01, widest = 179.9; // degrees
        const double fov = reader.number(key["fov"], where + ".fov", narrowest, widest);
        view.fov_y = static_cast<float>(fov * std::numbers::pi / 180);
    }
    if (key.contains("projection")) {
        const std::string at = where + ".projection";
        if (!key["projection"].is_string()) throw reader.error(at + " must be a name");
        try {
            view.projection = parse_projection(key["projection"].get<std::string>());
        } catch (const UsageError& error) {
            throw reader.error(at + ": " + error.what());
        }
    }
    return view;
}

} // namespace

CameraPath read_camera_path(const std::filesystem::path& file, const View& defaults,
                            glm::dvec3 origin) {
    const Reader reader{file};
    const Json root = reader.parse();
    reader.check_members(root, "the file", {"keys", "fps"});
    if (!root.contains("keys") || !root["keys"].is_array() || root["keys"].empty()) {
        throw reader.error("\"keys\" must be a list of at least one keyframe");
    }
    const double fps =
        root.contains("fps") ? reader.number(root["fps"], "fps", 0.001, 1000) : usual_fps;
    std::vector<CameraPath::Key> keys;
    View view = defaults;
    for (const Json& key : root["keys"]) {
        const std::string where = fmt::format("keys[{}]", keys.size());
        reader.check_members(key, where,
                             {"frame", "time", "eye", "target", "up", "fov", "projection"});
        const double frame = key_frame(reader, key, where, fps);
        if (!keys.empty() && frame <= keys.back().frame) {
            throw reader.error(where + " must come later than the key before it");
        }
        view = key_view(reader, key, where, origin, view);
        keys.push_back({frame, view});
    }
    CameraPath path{std::move(keys)};
    if (path.first_frame() > path.last_frame()) {
        throw reader.error("no whole frame lies between its first and last key");
    }
    return path;
}

std::string camera_file(const View& view, glm::dvec3 origin) {
    const auto vector = [](glm::vec3 v) { return OrderedJson{v.x, v.y, v.z}; };
    const auto point = [&](glm::vec3 v) {
        if (origin == glm::dvec3{0}) return vector(v); // with the digits of a float
        const glm::dvec3 at = origin + glm::dvec3{v};
        return OrderedJson{at.x, at.y, at.z};
    };
    const double degrees = static_cast<double>(view.fov_y) * 180 / std::numbers::pi;
    OrderedJson key{{"frame", 0},
                    {"eye", point(view.eye)},
                    {"target", point(view.target)},
                    {"up", vector(view.up)},
                    {"fov", degrees}};
    if (view.projection != Projection::perspective) key["projection"] = name_of(view.projection);
    return OrderedJson{{"keys", {key}}}.dump(2) + "\n";
}

} // namespace lineatlas
