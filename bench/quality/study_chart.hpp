#pragma once

#include "common/drawing.hpp"
#include "report.hpp"

namespace lineatlas::bench {

/// Fig. 6 as curves: mean error, wrong samples and sparkle over the number of probes, a curve per
/// depth scale and a row of panels per subject.
Drawing study_chart(const std::vector<StudyReport>& study);

} // namespace lineatlas::bench
