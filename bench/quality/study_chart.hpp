#pragma once

#include "common/drawing.hpp"
#include "report.hpp"

namespace lineatlas::bench {

/// The study of Fig. 6 as curves: mean error, wrong samples and sparkle over the number of probes.
/// There is a row of panels per subject and a curve per depth scale.
Drawing study_chart(const std::vector<StudyReport>& study);

} // namespace lineatlas::bench
