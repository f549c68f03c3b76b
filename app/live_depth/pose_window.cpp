#include "app/live_depth/pose_window.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::live_depth {
namespace {

/// Whether a depth camera may see the difference.
bool differ(const Transform& a, const Transform& b) {
  const Transform X = a.inverse() * b;
  return X.translation().norm() >= PoseWindow::kStep ||
         Eigen::AngleAxisd(X.linear()).angle() >= PoseWindow::kTurn;
}

bool differ(const std::vector<Transform>& a, const std::vector<Transform>& b) {
  return !std::equal(a.begin(), a.end(), b.begin(), b.end(),
                     [](const Transform& x, const Transform& y) { return !differ(x, y); });
}

}  // namespace

PoseWindow::PoseWindow(const moment::SceneCard& card, const std::vector<std::string>& objects)
    : moment_(moment::makeMoment(card)), poses_(objects.size()), last_(objects.size()) {
  for (const std::string& name : objects) {
    const auto found = std::find(card.objects.begin(), card.objects.end(), name);
    if (found == card.objects.end())
      throw UsageError("found a server without the object " + name + ", expected one of the same scene");
    number_.push_back(static_cast<std::size_t>(found - card.objects.begin()));
  }
}

bool PoseWindow::update(const viewer::LiveRecord& record, double now) {
  for (auto& poses : poses_) poses.clear();
  copy_.number = -1;
  if (!record.status(now).stale() && record.copyNewest(copy_)) {
    const double newest = copy_.t;
    add(copy_, true);
    // Steps beyond the last kept moment give it again.
    double before = -kInfinity;
    for (int step = 0; record.copyAt(newest - kWindow, step, copy_) && copy_.t > before; ++step) {
      before = copy_.t;
      if (before < newest) add(copy_, false);
    }
  }
  bool changed = false;
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    if (!differ(poses_[k], last_[k])) continue;
    changed = true;
    last_[k] = poses_[k];
  }
  return changed;
}

void PoseWindow::add(const viewer::LiveRecord::Copy& copy, bool is_newest) {
  if (!moment::readMoment(copy.frame, moment_)) return;
  for (std::size_t k = 0; k < number_.size(); ++k) {
    const view::ObjectSnapshot& object = moment_.shown.objects[number_[k]];
    std::vector<Transform>& poses = poses_[k];
    if (scene::isPoseLost(object.pose_state) || (!is_newest && poses.empty())) continue;
    if (poses.empty() || differ(poses.back(), object.X_WB)) poses.push_back(object.X_WB);
  }
}

}  // namespace abstand::live_depth
