#include "json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "io/atomic_file.hpp"

namespace lineatlas::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Rounds milliseconds to a tenth of a microsecond, which is finer than the clock.
double rounded(double value) {
    return std::round(value * 1e4) / 1e4;
}

Json entry(const Measured& measured) {
    Json json{{"ms", rounded(measured.ms())}, {"fps", rounded(measured.fps())}};
    json["stages"] = Json::object();
    for (const StageTime& stage : measured.stages) {
        json["stages"][stage.name] = rounded(stage.milliseconds);
    }
    json["frames"] = measured.frames();
    return json;
}

Json entries(const std::vector<Measured>& all) {
    Json json = Json::object();
    for (const Measured& measured : all) {
        if (measured.valid()) json[measured.name] = entry(measured);
    }
    return json;
}

Json optional(const std::optional<double>& value) {
    return value ? Json(rounded(*value)) : Json(nullptr);
}

} // namespace

void write_json(const std::filesystem::path& path, const Report& report) {
    Json json{{"device", report.device},
              {"gl", report.gl},
              {"size", {report.size.x, report.size.y}},
              {"scenes", Json::object()},
              {"goals", Json::array()}};
    for (const SceneResult& scene : report.scenes) {
        json["scenes"][scene.name] = Json{{"triangles", scene.triangles},
                                          {"segments", scene.segments},
                                          {"methods", entries(scene.methods)},
                                          {"depth", entries(scene.depth)}};
    }
    for (const Goal& goal : goals(report)) {
        json["goals"].push_back(Json{{"ratio", goal.what},
                                     {"scene", goal.scene},
                                     {"paper", optional(goal.paper)},
                                     {"ours", optional(goal.ours)},
                                     {"must", goal.must},
                                     {"aim", goal.aim},
                                     {"at_most", goal.at_most}});
    }
    // JSON must be UTF-8; file names in it need not be.
    const std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

} // namespace lineatlas::bench
