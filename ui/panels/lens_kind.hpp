// The kind of depth camera that a lens makes.
#pragma once

#include "ui/document/sensor_plan.hpp"
#include "ui/model/coverage_report.hpp"

namespace abstand::ui {

/// With the edges of the field of view; its title has the size of the image and the range in the shown
/// language. `name`: as SensorPlan::sensor.
SensorKind kindOf(const SensorLens& lens, const QString& name);

}  // namespace abstand::ui
