#include "ui/model/depth_cloud.hpp"

#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr QRgb kBackgroundPoint = 0xff8a929b;  // visible before the dark and the light background
constexpr QRgb kPersonPoint = 0xff009e73;      // green of Okabe and Ito
constexpr QRgb kYellow = 0xfff0e442;           // of Okabe and Ito; amber is that of a left arm

}  // namespace

QRgb colourOf(JointLook look) {
  switch (look) {
    case JointLook::kTracked:
      return 0xffffffff;
    case JointLook::kInferred:
      return kYellow;
    case JointLook::kUnknown:
      break;
  }
  return kVermillion;
}

QRgb colourOf(const CloudPoint& point, CloudColours colours) {
  if (point.part == CloudPart::kBackground) return kBackgroundPoint;
  if (colours == CloudColours::kConfidence)
    return point.part == CloudPart::kPerson ? colourOf(point.look) : kBackgroundPoint;
  return point.part == CloudPart::kPerson ? kPersonPoint : kBlue;
}

}  // namespace abstand::ui
