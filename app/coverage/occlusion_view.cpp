#include "app/coverage/occlusion_view.hpp"

#include <cmath>

namespace abstand::coverage {

OcclusionView::OcclusionView(const Sensor& sensor, std::size_t people, int columns)
    : camera_(reduced(sensor.camera, columns)),
      nearest_(sensor.nearest),
      farthest_(sensor.farthest),
      X_CW_(sensor.camera.X_WC.inverse()) {
  for (std::size_t i = 0; i < kPeople + people; ++i) layers_.emplace_back(camera_);
}

void OcclusionView::clear() {
  for (tracking::DepthRender& layer : layers_) layer.clear();
}

void OcclusionView::draw(std::size_t layer, const geometry::TriangleMesh& mesh, const Transform& X_WB) {
  layers_[layer].draw(mesh, X_CW_ * X_WB);
}

Cause OcclusionView::causeOf(std::size_t person, const Vector3d& p_C) const {
  if (!(p_C.z() > 0.0)) return Cause::kOutOfImage;
  const Eigen::Vector2d pixel = camera_.pixelOf(p_C);
  const double u = std::round(pixel.x()), v = std::round(pixel.y());
  if (!(u >= 0.0 && v >= 0.0 && u < camera_.width && v < camera_.height)) return Cause::kOutOfImage;
  if (p_C.z() < nearest_ || p_C.z() > farthest_) return Cause::kOutOfRange;
  Cause cause = Cause::kSeen;
  double front = kInfinity;
  for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
    const double z = layers_[layer].image().at(static_cast<int>(u), static_cast<int>(v));
    const bool own = layer == kPeople + person;
    if (!(z > 0.0) || z >= front || z >= p_C.z() - (own ? kOwnGap : kOtherGap)) continue;
    front = z;
    cause = layer == kRobots   ? Cause::kRobot
            : layer == kThings ? Cause::kThing
            : own              ? Cause::kSelf
                               : Cause::kOtherPerson;
  }
  return cause;
}

Shares OcclusionView::shares(std::size_t person, std::span<const tracking::SurfaceSample> samples,
                             const Transform& X_WB) const {
  const Transform X_CB = X_CW_ * X_WB;
  std::array<double, kCauses> weights{};
  double sum = 0.0;
  for (const tracking::SurfaceSample& sample : samples) {
    const Vector3d p_C = X_CB * sample.p;
    const double squared = p_C.squaredNorm();
    const double facing = -p_C.dot(X_CB.linear() * sample.normal);
    // All samples stand for the same area.
    const double weight = facing / (squared * std::sqrt(squared));
    if (!(weight > 0.0)) continue;
    weights[static_cast<std::size_t>(causeOf(person, p_C))] += weight;
    sum += weight;
  }
  Shares shares{};
  if (!(sum > 0.0)) {
    shares[static_cast<std::size_t>(Cause::kOutOfRange)] = 1.0f;
    return shares;
  }
  for (std::size_t i = 0; i < kCauses; ++i) shares[i] = static_cast<float>(weights[i] / sum);
  return shares;
}

}  // namespace abstand::coverage
