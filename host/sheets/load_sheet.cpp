#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "core/drawing_scale.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/sheet.hpp"
#include "style/toml_file.hpp"

namespace lineatlas {
namespace {

namespace fs = std::filesystem;

std::string text_of(const toml::node& node) {
    const std::optional<std::string> text = node.value_exact<std::string>();
    if (!text) throw UsageError("it must be a text");
    return *text;
}

double number_of(const toml::node& node) {
    const std::optional<SettingValue> value = value_of(node);
    if (!value || !std::holds_alternative<double>(*value)) throw UsageError("it must be a number");
    return std::get<double>(*value);
}

double radius_of(const toml::node& node) {
    const double radius = number_of(node);
    if (!(radius > 0) || !std::isfinite(radius)) throw UsageError("it must be a number above 0");
    return radius;
}

/// An empty one is that of a sheet without the key, as in SheetOptions.
std::string scale_of(const toml::node& node) {
    std::string scale = text_of(node);
    if (!scale.empty()) parse_scale("the scale", scale);
    return scale;
}

template <std::size_t count>
std::array<double, count> numbers_of(const toml::node& node) {
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() != count)
        throw UsageError(fmt::format("it must be a list of {} numbers", count));
    std::array<double, count> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers[i] = number_of((*list)[i]);
    return numbers;
}

glm::dvec2 place_of(const toml::node& node) {
    const auto [x, y] = numbers_of<2>(node);
    return {x, y};
}

/// Reads one file; every message names it.
class SheetReader {
  public:
    explicit SheetReader(fs::path file) : file_(std::move(file)) { sheet_.views.clear(); }

    SheetOptions read() {
        const toml::table table = read_toml(file_);
        take_all(table, "a sheet", {"page", "projection", "scale", "fields", "views", "details"},
                 [&](std::string_view key, const toml::node& node) { take(key, node); });
        if (sheet_.views.empty()) sheet_.views = SheetOptions{}.views;
        return std::move(sheet_);
    }

  private:
    /// Gives each key of a table to `take`. Names the file, the line and the key in errors.
    template <class Take>
    void take_all(const toml::table& table, const char* what, const std::vector<std::string>& known,
                  const Take& take) const {
        for (const auto& [key, node] : table) {
            try {
                if (std::ranges::find(known, key.str()) == known.end())
                    throw UsageError(
                        fmt::format("{} has no such key{}", what, suggestion(key.str(), known)));
                take(key.str(), node);
            } catch (const UsageError& error) {
                throw FileError(fmt::format("{} line {}: {}: {}",
                                            value_to_toml(SettingValue{file_.string()}),
                                            key.source().begin.line, key.str(), error.what()));
            }
        }
    }

    void take(std::string_view key, const toml::node& node) {
        if (key == "page") sheet_.page = parse_page(text_of(node));
        if (key == "projection") sheet_.angle = parse_projection_angle(text_of(node));
        if (key == "scale") sheet_.scale = scale_of(node);
        if (key == "fields") take_fields(node);
        if (key == "views") take_tables(node, [&](const toml::table& table) { take_view(table); });
        if (key == "details")
            take_tables(node, [&](const toml::table& table) { take_detail(table); });
    }

    void take_fields(const toml::node& node) {
        const toml::table* table = node.as_table();
        if (table == nullptr) throw UsageError("it must be a table: [fields]");
        for (const auto& [name, value] : *table)
            set_field(sheet_.fields, name.str(), text_of(value));
    }

    template <class Take>
    static void take_tables(const toml::node& node, const Take& take) {
        const toml::array* list = node.as_array();
        if (list == nullptr || !std::ranges::all_of(*list, &toml::node::is_table))
            throw UsageError("it must be tables, each in [[double brackets]]");
        for (const toml::node& one : *list) take(*one.as_table());
    }

    void take_view(const toml::table& table) {
        SheetPlacement placed;
        take_all(table, "a view", {"view", "at", "scale"},
                 [&](std::string_view key, const toml::node& node) {
                     if (key == "view") placed.view = single_view(text_of(node));
                     if (key == "at") placed.at = place_of(node);
                     if (key == "scale") placed.scale = scale_of(node);
                 });
        if (placed.view.empty()) throw UsageError("each needs a \"view\"");
        sheet_.views.push_back(placed.view);
        if (placed.at || !placed.scale.empty()) sheet_.placements.push_back(std::move(placed));
    }

    static std::string single_view(const std::string& text) {
        const std::vector<std::string> views = parse_views(text);
        if (views.size() != 1) throw UsageError("it must be one view, such as \"front\"");
        return text;
    }

    void take_detail(const toml::table& table) {
        SheetDetail detail;
        take_all(table, "a detail", {"view", "center", "radius", "scale", "at"},
                 [&](std::string_view key, const toml::node& node) {
                     if (key == "view") detail.view = text_of(node);
                     if (key == "radius") detail.radius = radius_of(node);
                     if (key == "scale") detail.scale = scale_of(node);
                     if (key == "at") detail.at = place_of(node);
                     if (key != "center") return;
                     const auto [x, y, z] = numbers_of<3>(node);
                     detail.center = {x, y, z};
                 });
        for (const char* needed : {"view", "center", "radius"})
            if (!table.contains(needed))
                throw UsageError(fmt::format("each needs a \"{}\"", needed));
        sheet_.details.push_back(std::move(detail));
    }

    fs::path file_;
    SheetOptions sheet_;
};

} // namespace

SheetOptions load_sheet(const fs::path& file) {
    return SheetReader{file}.read();
}

} // namespace lineatlas
