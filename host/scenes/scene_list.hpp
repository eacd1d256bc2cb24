#pragma once

#include "lineatlas/scenes.hpp"

namespace lineatlas::scenes {

Scene make_clevis();
Scene make_house();
Scene make_ship();
Scene make_office();

} // namespace lineatlas::scenes
