#include "tracking/tracker/lone_camera.hpp"

#include <cmath>

#include "tracking/tracker/middle_joints.hpp"

namespace abstand::tracking {
namespace {

// Share of the points that a body explains whose place counts.
constexpr double kPlaceExplained = 0.9;

TrackedPerson::Options withUsualBody(TrackedPerson::Options options) {
  options.fit_body = false;
  return options;
}

}  // namespace

LoneCamera::LoneCamera(const DepthCamera& camera, const TrackedPerson::Options& options)
    : camera_{&camera}, options_{withUsualBody(options)}, views_{{&camera, 1}} {}

void LoneCamera::see(double t, const DepthFrame& frame, const KnownThings& known) {
  moment_.t = t;
  moment_.frames.assign(1, &frame);
  moment_.is_new.assign(1, true);
  people_.clear();
  views_.see(moment_, known);
  views_.each([&](int id, std::size_t, std::span<const PersonImage> images) {
    const TrackedBody* body = trackers_.try_emplace(id, options_).first->second.see(t, images);
    if (!body || !body->found || body->misfit.explained < kPlaceExplained) return;
    people_.push_back(middleJoints(body->frame));
    people_.back().t = t;
  });
}

bool LoneCamera::seesThrough(const humanmodel::SkeletonFrame& person) const {
  if (moment_.frames.empty()) return false;
  const DepthImage& image = moment_.frames.front()->image;
  const Transform X_CW = camera_->X_WC.inverse();
  int in_view = 0, through = 0;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    if (!person.has(static_cast<humanmodel::Joint>(j))) continue;
    const Vector3d p_C = X_CW * person.p[j];
    if (p_C.z() <= 0.0) continue;
    const long u = std::lround(camera_->fx * p_C.x() / p_C.z() + camera_->cx),
               v = std::lround(camera_->fy * p_C.y() / p_C.z() + camera_->cy);
    if (u < 0 || v < 0 || u >= image.width || v >= image.height) continue;
    const auto z = static_cast<double>(image.at(static_cast<int>(u), static_cast<int>(v)));
    ++in_view;
    through += z > p_C.z() + kBehind;
  }
  return 2 * through > in_view;
}

}  // namespace abstand::tracking
