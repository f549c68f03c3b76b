#include "ui/panels/lens_kind.hpp"

#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

SensorKind kindOf(const SensorLens& lens, const QString& name) {
  SensorKind kind;
  kind.name = name;
  kind.title = tr("%1: %2 x %3 pixels, %4 to %5 m")
                   .arg(lens.name)
                   .arg(lens.width)
                   .arg(lens.height)
                   .arg(fixed(lens.nearest, 1), fixed(lens.farthest, 1));
  // The image ends half a pixel beside the centre of its first and last pixels.
  kind.left = (-0.5 - lens.cx) / lens.fx;
  kind.right = (lens.width - 0.5 - lens.cx) / lens.fx;
  kind.top = (-0.5 - lens.cy) / lens.fy;
  kind.bottom = (lens.height - 0.5 - lens.cy) / lens.fy;
  kind.nearest = lens.nearest;
  kind.farthest = lens.farthest;
  return kind;
}

}  // namespace abstand::ui
