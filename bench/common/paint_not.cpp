// Replaces paint.cpp in builds without OpenImageIO.

#include "lineatlas/error.hpp"
#include "paint.hpp"

namespace lineatlas::bench {

Image paint(const Drawing&) {
    check_painting();
    return {};
}

void check_painting() {
    throw DeviceError("this build has no OpenImageIO to draw a chart as .png; write it as .svg");
}

} // namespace lineatlas::bench
