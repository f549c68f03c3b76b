// Markers on a body of known size that moves, with noise, gaps and exchanged labels, from fixed seeds.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/base/data_folder.hpp"
#include "tracking/markers/marker_solution.hpp"

namespace abstand::testing {

struct SyntheticMarkers {
  tracking::BodyRig base, body;  ///< what the solver starts from, and the truth
  tracking::SizeVector sizes;
  std::vector<tracking::FoundMarker> found;  ///< on the base, as a set has them
  std::vector<double> t;
  std::vector<tracking::MarkerPlaces> moments;
  std::vector<humanmodel::SkeletonFrame> joints;  ///< the truth
};

/// Walking on the spot with arms that swing and bend, a trunk that bows and turns.
inline tracking::RigPose walkingPose(const tracking::BodyRig& rig, double t) {
  tracking::BodySolver::Vector d = tracking::BodySolver::Vector::Zero();
  const auto at = [&](tracking::RigSegment s, int k) -> double& { return d(rig[s].column + k); };
  const double w = 2.0 * kPi * 0.9 * t;
  using enum tracking::RigSegment;
  d.head<3>() = Vector3d(0.1 * std::sin(0.5 * w), 0.05 * std::cos(w), 0.95 + 0.02 * std::sin(2.0 * w));
  d.segment<3>(3) = Vector3d(0.05 * std::sin(w), 0.1, 0.3 * std::sin(0.4 * w));
  at(kChest, 1) = 0.15 + 0.15 * std::sin(0.7 * w);
  at(kChest, 2) = 0.2 * std::sin(w);
  at(kHead, 1) = 0.2 * std::sin(0.5 * w);
  for (const double side : {1.0, -1.0}) {
    const auto on = [&](tracking::RigSegment left) {
      return side > 0 ? left : tracking::segmentAt(tracking::index(left) + 1);
    };
    at(on(kThighLeft), 1) = -0.25 - side * 0.45 * std::sin(w);
    at(on(kThighLeft), 0) = side * (0.1 + 0.1 * std::sin(0.6 * w));
    at(on(kThighLeft), 2) = 0.1 * std::sin(0.8 * w);
    at(on(kCalfLeft), 0) = 0.5 + 0.4 * std::sin(w + side);
    at(on(kFootLeft), 0) = 0.15 * std::sin(1.3 * w);
    at(on(kFootLeft), 1) = 0.1 * std::sin(w);
    at(on(kUpperArmLeft), 1) = -0.3 + side * 0.5 * std::sin(w);
    at(on(kUpperArmLeft), 0) = side * (0.35 + 0.2 * std::sin(0.5 * w));
    at(on(kForearmLeft), 0) = 0.8 + 0.5 * std::sin(0.9 * w + side);
    at(on(kHandLeft), 0) = 0.3 * std::sin(w);
    at(on(kHandLeft), 1) = 0.2 * std::sin(0.7 * w);
  }
  tracking::RigPose pose;
  tracking::advance(rig, d, pose);
  return pose;
}

/// `noise` m a coordinate, `shift` m: how far markers sit from the set's places, along each axis.
inline SyntheticMarkers makeMarkers(std::uint64_t seed, double seconds, double rate, double noise,
                                    double shift) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  SyntheticMarkers m;
  m.base = tracking::makeRig(humanmodel::makeHuman({}));
  m.sizes = tracking::sameSizes();
  m.sizes[0] = 1.06;
  m.sizes[static_cast<int>(tracking::index(tracking::BodySize::kThigh))] = 0.04;
  m.sizes[static_cast<int>(tracking::index(tracking::BodySize::kCalf))] = -0.03;
  m.sizes[static_cast<int>(tracking::index(tracking::BodySize::kForearm))] = 0.05;
  m.body = tracking::resized(m.base, m.sizes);
  const tracking::MarkerSet set =
      tracking::loadMarkerSet(dataFolder() / "marker_sets" / "plug_in_gait.markers");
  std::vector<std::string> names;
  for (const auto& marker : set.markers) names.push_back(marker.names.front());
  for (auto& name : names)
    if (name.find(" + ") != std::string::npos) name = name.substr(0, 4);
  // Middles of two are given as one point here.
  tracking::MarkerSet single = set;
  for (std::size_t i = 0; i < names.size(); ++i) single.markers[i].names = {names[i]};
  m.found = tracking::matchMarkers(single, m.base, names).markers;
  std::vector<tracking::RigMarker> worn;
  for (const auto& f : m.found) {
    const Vector3d off(normal(random), normal(random), normal(random));
    worn.push_back({f.segment, tracking::growth(f.segment, m.sizes).cwiseProduct(f.p_S) + shift * off});
  }
  const auto count = static_cast<int>(seconds * rate);
  for (int i = 0; i < count; ++i) {
    m.t.push_back(i / rate);
    tracking::RigPlacement X_WS;
    tracking::place(m.body, walkingPose(m.body, m.t.back()), X_WS);
    tracking::MarkerPlaces places;
    for (const auto& w : worn)
      places.push_back(X_WS[tracking::index(w.segment)] * w.p_S +
                       noise * Vector3d(normal(random), normal(random), normal(random)));
    m.moments.push_back(std::move(places));
    humanmodel::SkeletonFrame frame;
    frame.t = m.t.back();
    tracking::jointsOf(m.body, X_WS, humanmodel::JointState::kTracked, frame);
    m.joints.push_back(frame);
  }
  return m;
}

}  // namespace abstand::testing
