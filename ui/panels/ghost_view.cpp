// A stick figure from the front and from the side.
#include "ui/panels/ghost_view.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr double kCell = 0.5;         // m, of the grid
constexpr double kShownHeight = 2.2;  // m
constexpr const char* kBoneNames[][2] = {{"pelvis", "spine"},
                                         {"spine", "thorax"},
                                         {"thorax", "neck"},
                                         {"neck", "head"},
                                         {"head", "head_top"},
                                         {"neck", "shoulder_left"},
                                         {"shoulder_left", "elbow_left"},
                                         {"elbow_left", "wrist_left"},
                                         {"wrist_left", "hand_left"},
                                         {"neck", "shoulder_right"},
                                         {"shoulder_right", "elbow_right"},
                                         {"elbow_right", "wrist_right"},
                                         {"wrist_right", "hand_right"},
                                         {"pelvis", "hip_left"},
                                         {"hip_left", "knee_left"},
                                         {"knee_left", "ankle_left"},
                                         {"ankle_left", "toe_left"},
                                         {"pelvis", "hip_right"},
                                         {"hip_right", "knee_right"},
                                         {"knee_right", "ankle_right"},
                                         {"ankle_right", "toe_right"},
                                         // Where the spine is not known.
                                         {"pelvis", "neck"}};

}  // namespace

GhostView::GhostView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(320, 260);
  setAccessibleName(tr("Skeleton as it is read, from the front and from the side"));
}

void GhostView::setFound(const ImportFound& found) {
  found_ = found;
  bones_.clear();
  for (const auto& [from, to] : kBoneNames) {
    const Bone bone{found_.canonical.indexOf(QLatin1String(from)),
                    found_.canonical.indexOf(QLatin1String(to))};
    if (bone.from >= 0 && bone.to >= 0) bones_.push_back(bone);
  }
  setFrame(frame_);
}

void GhostView::setFrame(int frame) {
  frame_ = std::clamp(frame, 0, std::max(0, static_cast<int>(found_.frames.size()) - 1));
  update();
}

bool GhostView::known(const Bone& bone) const {
  if (found_.frames.empty()) return false;
  const auto& joints = found_.frames[static_cast<std::size_t>(frame_)].joints;
  return joints[static_cast<std::size_t>(bone.from)].allFinite() &&
         joints[static_cast<std::size_t>(bone.to)].allFinite();
}

int GhostView::bones() const {
  return static_cast<int>(
      std::count_if(bones_.begin(), bones_.end(), [this](const Bone& bone) { return known(bone); }));
}

void GhostView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (bones() == 0) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter, tr("No joints are known at this moment"));
    return;
  }
  const int half = width() / 2;
  paintFigure(painter, QRect(0, 0, half, height()), 1, tr("along x"));
  paintFigure(painter, QRect(half, 0, width() - half, height()), 0, tr("along y"));
}

/// `across`: the coordinate that goes to the right.
void GhostView::paintFigure(QPainter& painter, const QRect& place, int across, const QString& title) const {
  const auto& joints = found_.frames[static_cast<std::size_t>(frame_)].joints;
  double middle = 0.0, low = kInfinity, high = -kInfinity;
  int count = 0;
  for (const Vector3d& joint : joints) {
    if (!joint.allFinite()) continue;
    middle += joint[across];
    low = std::min(low, joint.z());
    high = std::max(high, joint.z());
    ++count;
  }
  middle /= std::max(1, count);
  const double scale = (place.height() - 40.0) / std::max(kShownHeight, high - low + 0.2);
  // The floor stays in sight; a person who is far above or below it is shown where the person is.
  const double floor = low < -0.3 || low > 1.0 ? low : 0.0;
  const auto at = [&](double right, double up) {
    return QPointF(place.center().x() + scale * (right - middle),
                   place.bottom() - 16.0 - scale * (up - floor));
  };
  painter.save();
  painter.setClipRect(place);
  painter.setPen(palette().color(QPalette::Midlight));
  for (double up = floor; up < floor + kShownHeight + kCell; up += kCell)
    painter.drawLine(QPointF(place.left(), at(0.0, up).y()), QPointF(place.right(), at(0.0, up).y()));
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(place.adjusted(6, 4, -6, -4), Qt::AlignTop | Qt::AlignLeft, title);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool has_spine = std::count_if(bones_.begin(), bones_.begin() + 3,
                                       [this](const Bone& bone) { return known(bone); }) == 3;
  for (const Bone& bone : bones_) {
    const QString& from = found_.canonical[bone.from];
    const QString& to = found_.canonical[bone.to];
    const bool is_spare = from == QLatin1String("pelvis") && to == QLatin1String("neck");
    if (!known(bone) || (is_spare && has_spine)) continue;
    const QColor colour = to.endsWith(QLatin1String("left"))    ? QColor(kBlue)
                          : to.endsWith(QLatin1String("right")) ? QColor(0xffc07820)
                                                                : palette().color(QPalette::Text);
    painter.setPen(QPen(colour, 3.0, Qt::SolidLine, Qt::RoundCap));
    const Vector3d& a = joints[static_cast<std::size_t>(bone.from)];
    const Vector3d& b = joints[static_cast<std::size_t>(bone.to)];
    painter.drawLine(at(a[across], a.z()), at(b[across], b.z()));
  }
  painter.restore();
}

}  // namespace abstand::ui
