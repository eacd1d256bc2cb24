#pragma once

#include <string>

namespace lineatlas::test {

struct GlFaults {
    int fail_creation = 0; ///< the n-th allocation, mapping or shader from now on fails, 0: none
    int creations = 0;     ///< since it was set to 0, failed ones too
    long live = 0;         ///< objects made and not deleted since the functions were hooked
    bool context_lost = false;

    // Limits of a smaller GL; 0: the driver's own. Larger objects fail as the standard says.
    /// The number of viewports and buffer textures that GL has cut off.
    int largest_side = 0;           ///< of textures, renderbuffers and viewports
    int largest_buffer_texture = 0; ///< texels
    long largest_allocation = 0;    ///< bytes
    std::string renderer{};         ///< its name; empty: the driver's own
    int beyond = 0;
};
GlFaults& gl_faults();

/// Puts these faults in front of the GL functions of this process (those of libepoxy). Call it
/// once, with a current context.
void hook_gl();

} // namespace lineatlas::test
