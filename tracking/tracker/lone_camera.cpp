#include "tracking/tracker/lone_camera.hpp"

#include <cmath>

#include "tracking/tracker/middle_joints.hpp"

namespace abstand::tracking {
namespace {

TrackedPerson::Options forPlaces(TrackedPerson::Options options) {
  options.fit_body = false;
  options.states_spreads = false;
  return options;
}

}  // namespace

LoneCamera::LoneCamera(const DepthCamera& camera, std::size_t number, const TrackedPerson::Options& options)
    : camera_{&camera}, number_{number}, options_{forPlaces(options)} {}

void LoneCamera::see(const DepthMoment& moment, PeopleViews& views) {
  image_ = &moment.frames[number_]->image;
  labels_ = views.labels(number_);
  people_.clear();
  views.eachIn(number_, [&](int id, const PersonImage& image) {
    const TrackedBody* body = trackers_.try_emplace(id, options_).first->second.see(moment.t, {&image, 1});
    if (!body || !body->found) return;
    people_.push_back({id, body->frame, middleJoints(body->frame), body->misfit.explained});
  });
}

bool LoneCamera::seesThrough(const humanmodel::SkeletonFrame& person) const {
  if (!image_) return false;
  const DepthImage& image = *image_;
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
