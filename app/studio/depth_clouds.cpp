#include "app/studio/depth_clouds.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/shape.hpp"
#include "tracking/depth/simulator/depth_render.hpp"

namespace abstand::studio {

namespace {

using humanmodel::JointState;

/// Camera of every n-th pixel.
tracking::DepthCamera thinned(const tracking::DepthCamera& camera, int stride) {
  tracking::DepthCamera coarse = camera;
  coarse.width = camera.width / stride;
  coarse.height = camera.height / stride;
  coarse.fx /= stride;
  coarse.fy /= stride;
  coarse.cx = (camera.cx - stride / 2) / stride;
  coarse.cy = (camera.cy - stride / 2) / stride;
  return coarse;
}

/// A fitted body, and the world of the camera in the frames of its segments.
struct PlacedBody {
  const tracking::FittedImage* fitted;
  tracking::RigPlacement X_SR;
};

std::vector<PlacedBody> bodiesAt(const std::vector<const DepthPerson*>& people, std::size_t image) {
  std::vector<PlacedBody> bodies;
  for (const DepthPerson* person : people) {
    PlacedBody body{&person->clip->images[image], {}};
    if (!body.fitted->found) continue;
    tracking::place(*body.fitted->rig, body.fitted->pose, body.X_SR);
    for (Transform& X : body.X_SR) X = X.inverse();
    bodies.push_back(body);
  }
  return bodies;
}

/// m, from a point to the surface of the body; negative inside.
double distanceToBody(const PlacedBody& body, const Vector3d& p_R) {
  double least = kInfinity;
  for (std::size_t s = 0; s < tracking::kRigSegments; ++s) {
    const tracking::RigPart& part = body.fitted->rig->parts[s];
    least = std::min(least,
                     geometry::distanceTo(part.shape, Vector3d(body.X_SR[s] * p_R - part.p_shape)).distance);
  }
  return least;
}

ui::JointLook lookAt(const humanmodel::SkeletonFrame& frame, const Vector3d& p) {
  double least = kInfinity;
  JointState state = JointState::kMissing;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    if (frame.state[j] == JointState::kMissing) continue;
    const double distance = (frame.p[j] - p).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    state = frame.state[j];
  }
  return jointLook(state);
}

bool shareImages(const DepthPerson& a, const DepthPerson& b) {
  return a.clip->path == b.clip->path && a.clip->times == b.clip->times &&
         a.clip->first_t == b.clip->first_t && a.speed == b.speed && a.X_WR.matrix() == b.X_WR.matrix();
}

/// Links of robots: object, its mesh.
std::vector<std::pair<std::size_t, const geometry::TriangleMesh*>> robotMeshes(
    const view::SceneOutline& outline) {
  std::vector<std::pair<std::size_t, const geometry::TriangleMesh*>> robots;
  for (std::size_t i = 0; i < outline.objects.size() && i < outline.meshes.size(); ++i) {
    const auto object = static_cast<int>(i);
    if (view::pairClassOf(outline, {object, object}) == view::PairClass::kRobotRobot)
      robots.emplace_back(i, &outline.meshes[i]);
  }
  return robots;
}

}  // namespace

int cloudStride(int width, int height) {
  int stride = 1;
  while (static_cast<long>(width / stride) * (height / stride) > kMaxCloudPoints) ++stride;
  return stride;
}

std::vector<ui::CloudPoint> cloudOf(
    const std::vector<const DepthPerson*>& people, std::size_t image, const tracking::DepthImage& depth,
    const std::vector<std::pair<const geometry::TriangleMesh*, Transform>>& robots) {
  const DepthPerson& person = *people.front();
  const tracking::FittedClip& clip = *person.clip;
  const int stride = cloudStride(depth.width, depth.height);
  const tracking::DepthCamera coarse = thinned(clip.camera, stride);
  const Transform X_CW = (person.X_WR * clip.camera.X_WC).inverse();
  tracking::DepthRender render(coarse);
  render.clear();
  for (const auto& [mesh, X_WB] : robots) render.draw(*mesh, X_CW * X_WB);
  const std::vector<PlacedBody> bodies = bodiesAt(people, image);
  std::vector<ui::CloudPoint> points;
  for (int v = 0; v < coarse.height; ++v)
    for (int u = 0; u < coarse.width; ++u) {
      const auto z = static_cast<double>(depth.at(u * stride + stride / 2, v * stride + stride / 2));
      if (!(z > 0.0)) continue;
      const Vector3d p_C = coarse.at(u, v, z);
      const Vector3d p_R = clip.camera.X_WC * p_C;
      const auto drawn = static_cast<double>(render.image().at(u, v));
      const double to_robot = drawn > 0.0 ? std::abs(z - drawn) : kInfinity;
      double to_body = kInfinity;
      const PlacedBody* nearest = nullptr;
      for (const PlacedBody& body : bodies) {
        const double distance = distanceToBody(body, p_R);
        if (!(distance < to_body)) continue;
        to_body = distance;
        nearest = &body;
      }
      ui::CloudPoint point;
      point.p_W = (person.X_WR * p_R).cast<float>();
      if (nearest && to_body < kCloudReach && to_body <= to_robot) {
        point.part = ui::CloudPart::kPerson;
        point.look = lookAt(nearest->fitted->joints, p_R);
      } else if (to_robot < kCloudReach) {
        point.part = ui::CloudPart::kRobot;
      }
      points.push_back(point);
    }
  return points;
}

DepthClouds::DepthClouds(std::vector<DepthPerson> people, const view::SceneOutline& outline)
    : people_(std::move(people)),
      robots_(robotMeshes(outline)),
      streams_(people_.size()),
      reader_([this](const ui::CloudRequest& request) { return read(request); }) {}

std::vector<std::size_t> DepthClouds::imagesAt(double t) const {
  std::vector<std::size_t> images;
  for (const DepthPerson& person : people_) images.push_back(imageOfMoment(person, t));
  return images;
}

ui::DepthCloud DepthClouds::read(const ui::CloudRequest& request) {
  ui::DepthCloud cloud;
  cloud.person = request.person;
  cloud.images = imagesAt(request.t);
  std::vector<std::pair<const geometry::TriangleMesh*, Transform>> robots;
  for (const auto& [object, mesh] : robots_)
    if (object < request.X_WB.size()) robots.emplace_back(mesh, request.X_WB[object]);
  for (std::size_t i = 0; i < people_.size(); ++i) {
    if (request.person >= 0 && static_cast<std::size_t>(request.person) != i) continue;
    std::vector<const DepthPerson*> seen;  // by the camera of this one
    bool done = false;
    for (std::size_t k = 0; k < people_.size(); ++k) {
      if (k != i && !shareImages(people_[i], people_[k])) continue;
      seen.push_back(&people_[k]);
      done |= request.person < 0 && k < i;
    }
    if (done) continue;
    try {
      if (!streams_[i])
        streams_[i] = tracking::openDepthStream(people_[i].clip->path, people_[i].clip->options);
      tracking::DepthFrame frame;
      streams_[i]->seek(cloud.images[i]);
      if (!streams_[i]->next(frame)) continue;
      const std::vector<ui::CloudPoint> points = cloudOf(seen, cloud.images[i], frame.image, robots);
      cloud.points.insert(cloud.points.end(), points.begin(), points.end());
    } catch (const std::exception& e) {
      // The file may have gone since it was tracked.
      cloud.problem = QString::fromUtf8(e.what());
      streams_[i].reset();
    }
  }
  return cloud;
}

}  // namespace abstand::studio
