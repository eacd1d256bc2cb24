#pragma once

#include <string>

namespace lineatlas::test {

struct GlFaults {
    int fail_creation = 0; ///< the n-th allocation, mapping or shader from now on fails, 0: none
    int creations = 0;     ///< since it was set to 0, failed ones too
    long live = 0;         ///< objects made and not deleted since the functions were hooked
    bool context_lost = false;

    // A smaller GL; 0: as it is. What is larger fails as the standard says.
    int largest_side = 0;           ///< of textures, renderbuffers and viewports
    int largest_buffer_texture = 0; ///< texels
    long largest_allocation = 0;    ///< bytes
    std::string renderer{};         ///< its name; empty: its own
    int beyond = 0;                 ///< viewports and buffer textures that GL has cut off
};
GlFaults& gl_faults();

/// Puts the above in front of the GL functions of this process (those of libepoxy). Once, with a
/// context current.
void hook_gl();

} // namespace lineatlas::test
