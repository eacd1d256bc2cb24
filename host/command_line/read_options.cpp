#include "read_options.hpp"

#include <cmath>

#include <CLI/App.hpp>

#include "io/pen_images.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr const char* memory_option = "--read-memory";
constexpr const char* seconds_option = "--read-seconds";

} // namespace

void ReadOptions::declare(CLI::App& app) {
    app_ = &app;
    const std::string group = "Reading files (in a process of its own)";
    app.add_option(memory_option, gibibytes_,
                   "Memory that reading a file may take, in GiB; by default 2 plus 32 times the "
                   "size of a model's file, 0.5 for a picture")
        ->group(group);
    app.add_option(seconds_option, seconds_,
                   "Seconds that reading a file may take; by default 60, plus one for each MB of a "
                   "model")
        ->group(group);
}

void ReadOptions::check() const {
    const auto in_range = [&](const char* option, double value, double most) {
        if (app_->count(option) > 0 && !(value >= 0.001 && value <= most))
            throw UsageError(std::string{option} + " must be from 0.001 to " +
                             std::to_string(static_cast<int>(most)));
    };
    in_range(memory_option, gibibytes_, 1 << 20);
    in_range(seconds_option, seconds_, 1e6);
}

ReadLimits ReadOptions::limits() const {
    constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
    return {.memory = static_cast<std::uint64_t>(std::ceil(gibibytes_ * gibibyte)),
            .time =
                std::chrono::milliseconds{static_cast<std::int64_t>(std::ceil(seconds_ * 1000))}};
}

std::map<std::string, Image> ReadOptions::pen_images(const Style& style) const {
    return read_pen_images(style, {}, [this](const std::filesystem::path& path) {
        return read_image_isolated(path, limits());
    });
}

} // namespace lineatlas
