// Words and colours of what a planned depth camera would not see.
#pragma once

#include <QColor>

#include "ui/model/coverage_report.hpp"

namespace abstand::ui {

/// "Robot": the heading of a column.
QString hiddenTitle(HiddenBy cause);
/// "hidden by a robot": in a sentence.
QString hiddenText(HiddenBy cause);
/// Told apart by lightness as well as by hue.
QColor hiddenColour(HiddenBy cause);
/// "hand_left is hidden by a robot from 1.2 s to 1.9 s (0.7 s)".
QString spanText(const CoveragePart& part, const CoverageSpan& span);

}  // namespace abstand::ui
