// Placing, wrapping, rendering; and comparing.
#include "tests/tracking/tracker/simulated_clip.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "humanmodel/joint_covariance.hpp"
#include "humanmodel/part_uncertainty.hpp"
#include "tracking/depth/simulator/depth_render.hpp"
#include "tracking/depth/simulator/kinect_noise.hpp"
#include "tracking/depth/simulator/skin_body.hpp"
#include "tracking/recording/derived_joints.hpp"
#include "tracking/registry/open_recording.hpp"

namespace abstand::testing {
namespace {

using enum humanmodel::Joint;

constexpr double kRate = 30.0;  // Hz

/// Yaw (rad) of the hips: 0 where they face +x.
double facing(const humanmodel::SkeletonFrame& frame) {
  const Vector3d left = frame[kHipLeft] - frame[kHipRight];
  return std::atan2(-left.x(), left.y());
}

Matrix3d turned(double yaw) { return Eigen::AngleAxisd(yaw, Vector3d::UnitZ()).toRotationMatrix(); }

/// Into the clip's world: over the origin, facing +x, the lowest skin of all frames on z = 0.
void placeFrames(std::vector<humanmodel::SkeletonFrame>& frames, const tracking::SkinBody& skin,
                 double turn) {
  const double yaw = -facing(frames.front()), start = frames.front().t;
  const Vector3d hips = 0.5 * (frames.front()[kHipLeft] + frames.front()[kHipRight]);
  double low = kInfinity;
  for (const humanmodel::SkeletonFrame& frame : frames)
    for (const tracking::SkinPart& part : skin.wrap(frame))
      for (const Vector3d& p : part.mesh.vertices) low = std::min(low, p.z());
  for (humanmodel::SkeletonFrame& frame : frames)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (frame.state[j] != humanmodel::JointState::kMissing)
        frame.p[j] =
            turned(yaw + turn * (frame.t - start)) * (frame.p[j] - Vector3d(hips.x(), hips.y(), low));
}

geometry::TriangleMesh rectangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return {{a, b, c, a + c - b}, {{0, 1, 2}, {0, 2, 3}}};
}

bool isCompared(humanmodel::Joint j) { return j != kSpine && j != kThorax; }

humanmodel::Joint otherSide(humanmodel::Joint j) {
  if (j >= kShoulderLeft && j <= kHandLeft) return static_cast<humanmodel::Joint>(static_cast<int>(j) + 4);
  if (j >= kShoulderRight && j <= kHandRight) return static_cast<humanmodel::Joint>(static_cast<int>(j) - 4);
  if (j >= kHipLeft && j <= kToeLeft) return static_cast<humanmodel::Joint>(static_cast<int>(j) + 4);
  if (j >= kHipRight && j <= kToeRight) return static_cast<humanmodel::Joint>(static_cast<int>(j) - 4);
  return j;
}

void drawHeld(const HeldBox& box, const humanmodel::SkeletonFrame& frame, const Transform& X_CW,
              tracking::DepthRender& render) {
  const std::array<Vector3d, 8> p = box.corners(frame);
  // Bit k of a corner's index: whether it is high along axis k.
  constexpr std::array<std::array<std::size_t, 3>, 6> kFaces{
      {{0, 1, 3}, {4, 5, 7}, {0, 1, 5}, {2, 3, 7}, {0, 2, 6}, {1, 3, 7}}};
  for (const auto& [a, b, c] : kFaces) render.draw(rectangle(p[a], p[b], p[c]), X_CW);
}

using SkinPointer = std::shared_ptr<const tracking::SkinBody>;

SkinPointer skinFor(const ClipPlan& plan, const std::vector<humanmodel::SkeletonFrame>& truth) {
  tracking::SkinOptions options;
  options.clothing = plan.clothing;
  options.seed = plan.body_seed;
  return std::make_shared<const tracking::SkinBody>(tracking::statureOfLegs(truth).value_or(1.75), options);
}

/// `X_WC`: of the camera before it is pushed.
void drawRoom(const ClipPlan& plan, const Transform& X_WC, const Transform& X_CW,
              tracking::DepthRender& render) {
  Vector3d ahead = X_WC.linear().col(2);
  ahead.z() = 0.0;
  ahead.normalize();
  const Vector3d aside = 4.0 * ahead.cross(Vector3d::UnitZ()), up = 3.0 * Vector3d::UnitZ();
  Vector3d near = plan.eye - ahead, foot = plan.look + plan.wall * ahead;
  near.z() = foot.z() = 0.0;
  render.draw(rectangle(near - aside, near + aside, foot + aside), X_CW);
  render.draw(rectangle(foot - aside, foot + aside, foot + aside + up), X_CW);
}

void drawBox(const FurnitureBox& standing, double t, const Transform& X_CW, tracking::DepthRender& render) {
  const Vector3d off = std::sin(2.0 * kPi * t / FurnitureBox::kSwing) * standing.swing;
  const FurnitureBox box{standing.low + off, standing.high + off};
  const Vector3d size = box.high - box.low;
  for (int k = 0; k < 3; ++k) {
    const Vector3d u = size[(k + 1) % 3] * Vector3d::Unit((k + 1) % 3),
                   v = size[(k + 2) % 3] * Vector3d::Unit((k + 2) % 3);
    render.draw(rectangle(box.low, box.low + u, box.low + u + v), X_CW);
    render.draw(rectangle(box.high, box.high - u, box.high - u - v), X_CW);
  }
}

SimulatedClip seenClip(const ClipPlan& plan, std::vector<humanmodel::SkeletonFrame> truth,
                       const SkinPointer& skin, std::vector<FurnitureBox> furniture) {
  SimulatedClip clip;
  clip.truth = std::move(truth);
  clip.skin = skin;
  tracking::DepthSource source;
  source.camera.width = plan.width;
  source.camera.height = plan.width * 3 / 4;
  source.camera.fx = source.camera.fy = 580.0 * plan.width / 640.0;
  source.camera.cx = 0.5 * (source.camera.width - 1);
  source.camera.cy = 0.5 * (source.camera.height - 1);
  source.camera.X_WC = tracking::lookingAt(plan.eye, plan.look);
  source.facts.format = "simulated";
  source.facts.camera_known = source.facts.pose_known = true;
  for (const humanmodel::SkeletonFrame& frame : clip.truth) source.t.push_back(frame.t);
  source.load = [frames = clip.truth, skin, camera = source.camera, plan, boxes = std::move(furniture),
                 drawn =
                     std::make_shared<std::vector<tracking::DepthImage>>(clip.truth.size())](std::size_t i) {
    // A clip is read twice; drawing takes longer than tracking.
    tracking::DepthImage& image = (*drawn)[i];
    if (!image.z.empty()) return image;
    tracking::DepthRender render(camera);
    render.clear();
    Transform X_WC = camera.X_WC;
    if (frames[i].t >= plan.push_at)
      X_WC.rotate(Eigen::AngleAxisd(-plan.push, Vector3d::UnitX()) *
                  Eigen::AngleAxisd(plan.push_aside, Vector3d::UnitY()));
    const Transform X_CW = X_WC.inverse();
    for (const tracking::SkinPart& part : skin->wrap(frames[i])) render.draw(part.mesh, X_CW);
    if (plan.room) drawRoom(plan, camera.X_WC, X_CW, render);
    for (const FurnitureBox& box : boxes) drawBox(box, frames[i].t, X_CW, render);
    for (const HeldBox& box : plan.held) drawHeld(box, frames[i], X_CW, render);
    image = tracking::seenByKinect(render.image(), camera, tracking::kinectNoiseIn(camera), 1, i);
    return image;
  };
  clip.stream = std::make_unique<tracking::DepthStream>(std::move(source));
  return clip;
}

}  // namespace

std::array<Vector3d, 8> HeldBox::corners(const humanmodel::SkeletonFrame& frame) const {
  const Vector3d left_hand = frame[kHandLeft], right_hand = frame[kHandRight];
  const Vector3d left_bone = left_hand - frame[kWristLeft], right_bone = right_hand - frame[kWristRight];
  const Vector3d left = frame[kHipLeft] - frame[kHipRight];
  const auto squared = [](const Vector3d& v, const Vector3d& axis) {
    return Vector3d((v - v.dot(axis) * axis).normalized());
  };
  Transform X_WG = Transform::Identity();
  Vector3d x, y;
  if (grip == Grip::kBoth) {
    X_WG.translation() = 0.5 * (left_hand + right_hand);
    y = (left_hand - right_hand).normalized();
    x = squared(left_bone + right_bone, y);
  } else {
    X_WG.translation() = grip == Grip::kLeft ? left_hand : right_hand;
    x = (grip == Grip::kLeft ? left_bone : right_bone).normalized();
    y = squared(left, x);
  }
  X_WG.linear() << x, y, x.cross(y);
  std::array<Vector3d, 8> out;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = X_WG * Vector3d((i & 1u) != 0 ? high.x() : low.x(), (i & 2u) != 0 ? high.y() : low.y(),
                             (i & 4u) != 0 ? high.z() : low.z());
  return out;
}

SimulatedClip simulate(const ClipPlan& plan) {
  const tracking::Recording recording = tracking::openRecording(plan.recording);
  std::vector<humanmodel::SkeletonFrame> truth;
  for (double t = plan.start; t < plan.end && t <= recording.frames.back().t; t += 1.0 / kRate) {
    truth.push_back(recording.at(t));
    truth.back().t = t;
  }
  const SkinPointer skin = skinFor(plan, truth);
  placeFrames(truth, *skin, plan.turn);
  return seenClip(plan, std::move(truth), skin, {});
}

SimulatedClip simulate(const ClipPlan& plan, std::vector<humanmodel::SkeletonFrame> truth,
                       std::vector<FurnitureBox> furniture) {
  const SkinPointer skin = skinFor(plan, truth);
  return seenClip(plan, std::move(truth), skin, std::move(furniture));
}

tracking::DepthImage depthOf(std::span<const FurnitureBox> boxes, double t,
                             const tracking::DepthCamera& camera) {
  tracking::DepthRender render(camera);
  render.clear();
  for (const FurnitureBox& box : boxes) drawBox(box, t, camera.X_WC.inverse(), render);
  return render.image();
}

double JointErrors::mean(const std::vector<double>& errors) {
  return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

double JointErrors::quantile(const std::vector<double>& errors, double share) {
  return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
}

void JointErrors::Stated::add(const Stated& other) {
  error.insert(error.end(), other.error.begin(), other.error.end());
  reach.insert(reach.end(), other.reach.begin(), other.reach.end());
  largest.insert(largest.end(), other.largest.begin(), other.largest.end());
  joint.insert(joint.end(), other.joint.begin(), other.joint.end());
}

double JointErrors::Stated::within() const { return withinPlus({}); }

double JointErrors::Stated::withinLargest() const { return Stated{error, largest, {}, joint}.within(); }

double JointErrors::Stated::medianRatioOfLargest() const {
  return Stated{error, largest, {}, joint}.medianRatio();
}

double JointErrors::Stated::withinPlus(const std::array<double, humanmodel::kJointCount>& term) const {
  std::size_t within = 0;
  for (std::size_t i = 0; i < error.size(); ++i) within += error[i] <= reach[i] + term[joint[i]];
  return error.empty() ? 1.0 : static_cast<double>(within) / static_cast<double>(error.size());
}

double JointErrors::Stated::medianRatio() const {
  std::vector<double> ratio;
  for (std::size_t i = 0; i < error.size(); ++i) ratio.push_back(reach[i] / std::max(error[i], 1e-9));
  std::sort(ratio.begin(), ratio.end());
  return ratio.empty() ? kNaN : JointErrors::quantile(ratio, 0.5);
}

JointErrors compare(const std::vector<humanmodel::SkeletonFrame>& tracked,
                    const std::vector<humanmodel::SkeletonFrame>& truth) {
  JointErrors errors;
  std::array<Vector3d, humanmodel::kJointCount>& offset = errors.offset;
  std::array<int, humanmodel::kJointCount> count{};
  offset.fill(Vector3d::Zero());
  const auto each = [&](const auto& visit) {
    std::size_t k = 0;
    for (const humanmodel::SkeletonFrame& frame : tracked) {
      while (k + 1 < truth.size() && truth[k].t < frame.t - 0.5 / kRate) ++k;
      for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
        if (isCompared(static_cast<humanmodel::Joint>(j)) && frame.has(static_cast<humanmodel::Joint>(j)) &&
            truth[k].has(static_cast<humanmodel::Joint>(j)))
          visit(frame, j, Vector3d(frame.p[j] - truth[k].p[j]), turned(facing(truth[k])));
    }
  };
  each([&](const humanmodel::SkeletonFrame&, std::size_t j, const Vector3d& error, const Matrix3d& R_WH) {
    offset[j] += R_WH.transpose() * error;
    ++count[j];
  });
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
    if (count[j] > 0) offset[j] /= count[j];
  each([&](const humanmodel::SkeletonFrame& frame, std::size_t j, const Vector3d& error,
           const Matrix3d& R_WH) {
    errors.raw.push_back(error.norm());
    errors.aligned.push_back((error - R_WH * offset[j]).norm());
    JointErrors::Stated& stated =
        frame.state[j] == humanmodel::JointState::kInferred ? errors.inferred : errors.tracked;
    stated.error.push_back(error.norm());
    stated.joint.push_back(j);
    const Matrix3d covariance = humanmodel::covarianceOf(frame, static_cast<humanmodel::Joint>(j));
    stated.reach.push_back(
        humanmodel::radiusToward(covariance, error.norm() > 0.0 ? error.normalized() : Vector3d::UnitX()));
    stated.largest.push_back(humanmodel::partUncertainty(0.0, frame.spread[j]));
  });
  std::sort(errors.raw.begin(), errors.raw.end());
  std::sort(errors.aligned.begin(), errors.aligned.end());

  std::size_t k = 0, run = 0;
  for (const humanmodel::SkeletonFrame& frame : tracked) {
    while (k + 1 < truth.size() && truth[k].t < frame.t - 0.5 / kRate) ++k;
    double right = 0.0, exchanged = 0.0;
    bool has_body = false;
    for (std::size_t i = 0; i < humanmodel::kJointCount; ++i) {
      const auto j = static_cast<humanmodel::Joint>(i);
      if (otherSide(j) == j || !frame.has(j) || !truth[k].has(j) || !truth[k].has(otherSide(j))) continue;
      has_body = true;
      right += (frame[j] - truth[k][j]).norm();
      exchanged += (frame[j] - truth[k][otherSide(j)]).norm();
    }
    errors.lost += !has_body;
    run = has_body && exchanged < right ? run + 1 : 0;
    errors.longest_swap = std::max(errors.longest_swap, static_cast<double>(run) / kRate);
  }
  return errors;
}

std::vector<SideView> eightSides(double distance, double height) {
  constexpr int kSides = 8;
  std::vector<SideView> sides;
  for (int side = 0; side < kSides; ++side) {
    const double angle = 2.0 * kPi * side / kSides;
    sides.push_back({"_from_" + std::to_string(360 * side / kSides),
                     {distance * std::cos(angle), distance * std::sin(angle), height}});
  }
  return sides;
}

}  // namespace abstand::testing
