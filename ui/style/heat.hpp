// The colours of distances over time.
#pragma once

#include <QColor>

namespace abstand::ui {

/// Bright where a distance (m) is small, dark from 1 m on; ordered for every kind of colour vision.
QRgb heat(double distance);

}  // namespace abstand::ui
