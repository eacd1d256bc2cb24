#include "handover.hpp"

namespace lineatlas::interop {

void Handover::to_compute(std::span<const Passed> buffers) {
    glFinish();
    for (const Passed& passed : buffers) passed.buffer.enter_compute(passed.bytes);
}

void Handover::to_gl(std::span<const Passed> buffers) {
    for (const Passed& passed : buffers) passed.buffer.leave_compute(passed.bytes);
    backend_.finish();
    for (const Passed& passed : buffers) passed.buffer.enter_gl(passed.bytes);
}

} // namespace lineatlas::interop
