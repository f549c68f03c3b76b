#include "ui/model/coverage_text.hpp"

#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

QString hiddenTitle(HiddenBy cause) {
  switch (cause) {
    case HiddenBy::kSeen:
      return ui::tr("Seen");
    case HiddenBy::kUnknown:
      return ui::tr("Unknown");
    case HiddenBy::kOutOfImage:
      return ui::tr("Out of image");
    case HiddenBy::kOutOfRange:
      return ui::tr("Out of range");
    case HiddenBy::kRobot:
      return ui::tr("Robot");
    case HiddenBy::kThing:
      return ui::tr("Thing");
    case HiddenBy::kSelf:
      return ui::tr("Own body");
    case HiddenBy::kOtherPerson:
      return ui::tr("Other person");
  }
  return {};
}

QString hiddenText(HiddenBy cause) {
  switch (cause) {
    case HiddenBy::kSeen:
      return ui::tr("seen");
    case HiddenBy::kUnknown:
      return ui::tr("not in the recording");
    case HiddenBy::kOutOfImage:
      return ui::tr("outside of the image");
    case HiddenBy::kOutOfRange:
      return ui::tr("outside of the range of depths");
    case HiddenBy::kRobot:
      return ui::tr("hidden by a robot");
    case HiddenBy::kThing:
      return ui::tr("hidden by a thing of the room");
    case HiddenBy::kSelf:
      return ui::tr("hidden by the person's own body");
    case HiddenBy::kOtherPerson:
      return ui::tr("hidden by another person");
  }
  return {};
}

QColor hiddenColour(HiddenBy cause) {
  switch (cause) {
    case HiddenBy::kSeen:
      return {};
    case HiddenBy::kUnknown:
      return QColor(0x20, 0x24, 0x28);
    case HiddenBy::kOutOfImage:
      return QColor(kCalm);
    case HiddenBy::kOutOfRange:
      return QColor(0xa9, 0xb4, 0xbf);
    case HiddenBy::kRobot:
      return QColor(kVermillion);
    case HiddenBy::kThing:
      return QColor(kAmber);
    case HiddenBy::kSelf:
      return QColor(kBlue);
    case HiddenBy::kOtherPerson:
      return QColor(0xcc, 0x79, 0xa7);
  }
  return {};
}

QString spanText(const CoveragePart& part, const CoverageSpan& span) {
  return ui::tr("%1: %2 from %3 to %4 (%5)")
      .arg(part.name, hiddenText(span.cause), secondsWithUnit(span.from), secondsWithUnit(span.to),
           secondsWithUnit(span.to - span.from));
}

}  // namespace abstand::ui
