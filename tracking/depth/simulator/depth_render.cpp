// Renders depth images of meshes for an ideal camera.
#include "tracking/depth/simulator/depth_render.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand::tracking {
namespace {

constexpr double kNearest = 0.01;  // m

}  // namespace

DepthRender::DepthRender(const DepthCamera& camera) : camera_(camera), image_(camera.width, camera.height) {
  if (!camera.distortion.isZero(0.0))
    throw UsageError("found a camera with a distortion, expected one without to render for");
}

void DepthRender::clear() { std::fill(image_.z.begin(), image_.z.end(), 0.0f); }

void DepthRender::draw(const geometry::TriangleMesh& mesh, const Transform& X_CB) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    // The part of the triangle beyond the plane z = kNearest: at most four corners.
    std::array<Vector3d, 4> kept;
    std::size_t n = 0;
    Vector3d last = X_CB * mesh.corner(t, 2);
    for (int i = 0; i < 3; ++i) {
      const Vector3d p = X_CB * mesh.corner(t, i);
      if ((p.z() > kNearest) != (last.z() > kNearest))
        kept[n++] = last + (kNearest - last.z()) / (p.z() - last.z()) * (p - last);
      if (p.z() > kNearest) kept[n++] = p;
      last = p;
    }
    for (std::size_t i = 2; i < n; ++i) fill(kept[0], kept[i - 1], kept[i]);
  }
}

// 1 / z of a plane is linear in the image.
void DepthRender::fill(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const std::array corners{&a, &b, &c};
  Eigen::Array3d u, v, inverse;
  for (int i = 0; i < 3; ++i) {
    const Vector3d& p = *corners[static_cast<std::size_t>(i)];
    inverse[i] = 1.0 / p.z();
    u[i] = camera_.fx * p.x() * inverse[i] + camera_.cx;
    v[i] = camera_.fy * p.y() * inverse[i] + camera_.cy;
  }
  const double area = (u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]);
  // The negated form also rejects NaN.
  if (!(std::abs(area) > 0.0)) return;
  const double sign = area > 0.0 ? 1.0 : -1.0;
  const auto first = [](double lower, int) { return static_cast<int>(std::ceil(std::max(0.0, lower))); };
  const auto last = [](double upper, int size) {
    return static_cast<int>(std::floor(std::min(upper, size - 1.0)));
  };
  for (int y = first(v.minCoeff(), 0); y <= last(v.maxCoeff(), image_.height); ++y) {
    for (int x = first(u.minCoeff(), 0); x <= last(u.maxCoeff(), image_.width); ++x) {
      const double b_of_area = (x - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (y - v[0]),
                   c_of_area = (u[1] - u[0]) * (y - v[0]) - (x - u[0]) * (v[1] - v[0]);
      // Most points of the rectangle around a large triangle end here, before the divisions.
      if (b_of_area * sign < 0.0 || c_of_area * sign < 0.0) continue;
      const double wb = b_of_area / area, wc = c_of_area / area;
      const double wa = 1.0 - wb - wc;
      if (wa < 0.0 || wb < 0.0 || wc < 0.0) continue;
      const auto z = static_cast<float>(1.0 / (wa * inverse[0] + wb * inverse[1] + wc * inverse[2]));
      float& kept = image_.at(x, y);
      if (kept == 0.0f || z < kept) kept = z;
    }
  }
}

}  // namespace abstand::tracking
