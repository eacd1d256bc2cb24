// The registry of the built-in scenes.
#include "lineatlas/scenes.hpp"

#include <array>
#include <utility>

#include "lineatlas/error.hpp"
#include "scene_list.hpp"

namespace lineatlas {

namespace {

constexpr std::array<std::string_view, 4> names{"clevis", "house", "ship", "office"};
constexpr std::array<Scene (*)(), 4> makers{scenes::make_clevis, scenes::make_house,
                                            scenes::make_ship, scenes::make_office};

} // namespace

std::span<const std::string_view> scene_names() {
    return names;
}

Scene make_scene(std::string_view name) {
    std::string known;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == name) {
            Scene scene = makers[i]();
            scene.name = name;
            return scene;
        }
        known += (i == 0 ? "" : ", ") + std::string(names[i]);
    }
    throw UsageError("unknown scene '" + std::string(name) + "'; the built-in scenes are " + known);
}

} // namespace lineatlas
