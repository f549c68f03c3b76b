#include "ui/model/recording_event.hpp"

#include "ui/model/pair_level.hpp"
#include "ui/style/theme.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

std::string personOf(const std::string& part) { return part.substr(0, part.rfind('/')); }

QString kindText(EventKind kind) {
  switch (kind) {
    case EventKind::kLost:
      return tr("tracking lost");
    case EventKind::kInside:
      return tr("inside margin");
    case EventKind::kBetweenFrames:
      return tr("touch between frames");
    case EventKind::kContact:
      return tr("touching");
    case EventKind::kStop:
      return tr("robot stopped");
    case EventKind::kNear:
      break;
  }
  return tr("near miss");
}

QColor kindColour(EventKind kind) {
  switch (kind) {
    case EventKind::kContact:
    case EventKind::kBetweenFrames:
      return levelColour(PairLevel::kTouching);
    case EventKind::kInside:
      return levelColour(PairLevel::kInside);
    case EventKind::kNear:
      return levelColour(PairLevel::kNear);
    case EventKind::kStop:
      return QColor(kViolet);
    case EventKind::kLost:
      break;
  }
  return QColor(kCalm);
}

}  // namespace abstand::ui
