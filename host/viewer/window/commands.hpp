#pragma once

#include <span>
#include <string>

#include "ui.hpp"

namespace lineatlas::viewer {

/// A command that the user gives by a key, or by its name in the palette.
struct Command {
    const char* name;      ///< as it is read and searched
    int key = 0, mods = 0; ///< of GLFW; key 0: none
    void (*run)(Ui& ui) = nullptr;
};

/// The one table of commands, in the order of the list of keys.
std::span<const Command> commands();

/// "Ctrl + Shift + E"; empty without a key.
std::string key_text(const Command& command);

/// The command of a key, or null. `mods`: those of GLFW; locks do not count.
const Command* command_of(int key, int mods);

} // namespace lineatlas::viewer
