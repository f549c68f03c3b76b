// In which units lengths and angles are shown.
#include "ui/style/units.hpp"

#include <utility>

namespace abstand::ui {

Units& Units::shown() {
  static Units units;
  return units;
}

void Units::setLength(LengthUnit unit) {
  if (std::exchange(length_, unit) != unit) Q_EMIT changed();
}

void Units::setAngle(AngleUnit unit) {
  if (std::exchange(angle_, unit) != unit) Q_EMIT changed();
}

}  // namespace abstand::ui
