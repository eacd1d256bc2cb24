#pragma once

namespace lineatlas::test {

struct GlFaults {
    int fail_creation = 0; ///< the n-th allocation, mapping or shader from now on fails, 0: none
    int creations = 0;     ///< since it was set to 0, failed ones too
    long live = 0;         ///< objects made and not deleted since the functions were hooked
    bool context_lost = false;
};
GlFaults& gl_faults();

/// Puts the above in front of the GL functions of this process (those of libepoxy). Once, with a
/// context current.
void hook_gl();

} // namespace lineatlas::test
