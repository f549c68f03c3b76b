#include "tracking/markers/marker_solution.hpp"
#include "tracking/body/joint_spread.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace abstand::tracking {
namespace {

using enum RigSegment;

constexpr std::size_t kMoments = 60;
constexpr double kComplete = 0.8;                     // share of the largest number of markers in a moment
constexpr double kReach = 0.05;                       // m
constexpr double kFastest = 5.0;                      // m/s, of a marker between two moments
constexpr double kFastestTurn = 30.0;                 // rad/s
constexpr double kShortStep = 1e-3, kLongStep = 0.2;  // s
constexpr int kSteps = 10;
constexpr int kFewestSeen = 4;
constexpr double kMaxMisplaced = 0.4;     // share of the visible ones
constexpr double kLost = 0.5;             // share of its misplaced frames above which a marker is ignored
constexpr std::size_t kLongestWait = 64;  // moments between two searches
constexpr double kAlone = 0.050;          // m, spread of joints of a chest extrapolated from the pelvis
constexpr double kShoulderPlace = 0.015;  // m, of the joint below the acromion: no marker shows it
constexpr double kTracked = 0.030, kInferred = 0.120;  // m

int countSeen(const MarkerPlaces& places) {
  return static_cast<int>(
      std::count_if(places.begin(), places.end(), [](const Vector3d& p) { return std::isfinite(p.x()); }));
}

/// Evenly spaced among the moments with nearly all markers.
std::vector<MarkerPlaces> completeMoments(std::span<const MarkerPlaces> moments) {
  int max_seen = 0;
  for (const auto& m : moments) max_seen = std::max(max_seen, countSeen(m));
  std::vector<std::size_t> complete;
  for (std::size_t i = 0; i < moments.size(); ++i)
    if (countSeen(moments[i]) >= kComplete * max_seen) complete.push_back(i);
  std::vector<MarkerPlaces> picked;
  const std::size_t count = std::min(kMoments, complete.size());
  for (std::size_t i = 0; i < count; ++i) picked.push_back(moments[complete[i * complete.size() / count]]);
  return picked;
}

/// Standard deviation of each joint along its worst axis (m), from the markers of the last solve.
std::array<double, humanmodel::kJointCount> spreadsOf(const BodyRig& rig, const MarkerSolver& solver,
                                                      double rms) {
  auto spread = jointSpreads(rig, solver.problem(), solver.information());
  for (double& s : spread) s *= std::max(1.0, rms / kSkinMotion);
  for (const auto j : {humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kShoulderRight}) {
    double& s = spread[static_cast<std::size_t>(j)];
    s = std::hypot(s, kShoulderPlace);
  }
  return spread;
}

/// Statistics of the markers relative to the solved body.
class Ledger {
 public:
  explicit Ledger(std::span<const FoundMarker> found) : found_{found}, square_(found.size(), 0.0) {
    for (const auto& m : found) {
      MarkerUse use;
      use.label = m.label;
      use.segment = segmentName(m.segment);
      use_.push_back(use);
    }
  }

  void add(const MarkerBody& body, const RigPlacement& X_WS, const MarkerPlaces& seen) {
    std::vector<std::size_t> astray;
    const auto due = [&](std::size_t k) -> Vector3d {
      return X_WS[index(body.markers[k].segment)] * body.markers[k].p_S;
    };
    for (std::size_t k = 0; k < use_.size(); ++k) {
      if (!std::isfinite(seen[k].x())) continue;
      ++use_[k].seen;
      const double off = (due(k) - seen[k]).norm();
      if (off > kMisplaced) {
        ++use_[k].misplaced;
        astray.push_back(k);
      } else {
        square_[k] += off * off;
      }
    }
    for (const std::size_t a : astray)
      for (const std::size_t b : astray)
        if (a < b && (due(a) - seen[b]).norm() < kMisplaced && (due(b) - seen[a]).norm() < kMisplaced)
          ++swaps_[{a, b}];
  }

  void write(const MarkerBody& body, MarkerReport& report) const {
    double sum = 0.0;
    std::size_t fit = 0;
    for (std::size_t k = 0; k < use_.size(); ++k) {
      MarkerUse use = use_[k];
      if (use.seen == 0) {
        report.ignored.emplace_back(use.label, "never seen");
        continue;
      }
      if (static_cast<double>(use.misplaced) > kLost * static_cast<double>(use.seen)) {
        report.ignored.emplace_back(use.label, "does not fit " + use.segment + " in " +
                                                   std::to_string(use.misplaced) + " of " +
                                                   std::to_string(use.seen) + " frames");
        continue;
      }
      const std::size_t good = use.seen - use.misplaced;
      use.rms = std::sqrt(square_[k] / static_cast<double>(good));
      use.shift =
          (body.markers[k].p_S - growth(found_[k].segment, body.sizes).cwiseProduct(found_[k].p_S)).norm();
      sum += square_[k];
      fit += good;
      report.used.push_back(std::move(use));
    }
    report.rms = fit > 0 ? std::sqrt(sum / static_cast<double>(fit)) : 0.0;
    for (const auto& [pair, frames] : swaps_)
      report.swaps.push_back({use_[pair.first].label, use_[pair.second].label, frames});
  }

 private:
  std::span<const FoundMarker> found_;
  std::vector<MarkerUse> use_;
  std::vector<double> square_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> swaps_;
};

void writeBones(const BodyRig& rig, MarkerReport& report) {
  report.stature = rig.height;
  const auto add = [&](const char* name, double length) { report.bones.emplace_back(name, length); };
  add("hip_breadth", (rig[kThighLeft].p_parent - rig[kThighRight].p_parent).norm());
  add("trunk", farJoint(rig, kPelvis).norm() + farJoint(rig, kChest).norm());
  add("shoulder_breadth", (rig[kUpperArmLeft].p_parent - rig[kUpperArmRight].p_parent).norm());
  add("head", farJoint(rig, kHead).norm());
  add("upper_arm", farJoint(rig, kUpperArmLeft).norm());
  add("forearm", farJoint(rig, kForearmLeft).norm());
  add("hand", farJoint(rig, kHandLeft).norm());
  add("thigh", farJoint(rig, kThighLeft).norm());
  add("calf", farJoint(rig, kCalfLeft).norm());
  add("foot", farJoint(rig, kFootLeft).norm());
}

/// Without markers the chest is extrapolated from the pelvis; no other segment is.
humanmodel::JointState stateOf(humanmodel::Joint j, bool is_shown,
                               const std::array<double, humanmodel::kJointCount>& spread) {
  if (!is_shown) {
    const bool is_trunk =
        j == humanmodel::Joint::kSpine || j == humanmodel::Joint::kThorax || j == humanmodel::Joint::kNeck;
    const bool has_pelvis = spread[static_cast<std::size_t>(humanmodel::Joint::kPelvis)] <= kTracked;
    return is_trunk && has_pelvis ? humanmodel::JointState::kInferred : humanmodel::JointState::kMissing;
  }
  const double s = spread[static_cast<std::size_t>(j)];
  return s <= kTracked    ? humanmodel::JointState::kTracked
         : s <= kInferred ? humanmodel::JointState::kInferred
                          : humanmodel::JointState::kMissing;
}

bool isGood(const MarkerPose& pose) {
  return pose.seen >= kFewestSeen && pose.misplaced <= kMaxMisplaced * pose.seen;
}

}  // namespace

MarkerSolution solveMarkers(const BodyRig& base, std::span<const FoundMarker> found,
                            std::span<const double> t, std::span<const MarkerPlaces> moments,
                            std::optional<double> stature) {
  MarkerSolution out;
  out.body = calibrate(base, found, completeMoments(moments), stature);
  const BodyRig& rig = out.body.rig;
  MarkerSolver solver(rig);
  Ledger ledger(found);
  PoseHold hold;
  hold.to_rest = restWeights(rig, out.body.markers);
  const auto observed = observedSegments(rig, out.body.markers);
  double last_t = 0.0;
  std::size_t wait = 0, next_wait = 1;
  out.frames.resize(moments.size());
  for (std::size_t i = 0; i < moments.size(); ++i) {
    humanmodel::SkeletonFrame& frame = out.frames[i];
    frame.t = t[i];
    if (countSeen(moments[i]) == 0) {
      ++out.report.unseen;
      continue;
    }
    MarkerPose pose;
    if (hold.last) {
      const double dt = std::clamp(t[i] - last_t, kShortStep, kLongStep);
      hold.turn = kFastestTurn * dt;
      pose = solver.solve(out.body.markers, moments[i], *hold.last, hold, kReach + kFastest * dt, kSteps);
      pose = solver.solve(out.body.markers, moments[i], pose.pose, hold, kReach, kSteps);
    }
    if (!isGood(pose) && countSeen(moments[i]) >= kFewestSeen && wait == 0) {
      // After a loss a search; if nothing is found, at increasing intervals.
      hold.last.reset();
      pose = solver.search(out.body.markers, moments[i], hold);
      next_wait = isGood(pose) ? 1 : std::min(2 * next_wait, kLongestWait);
      wait = isGood(pose) ? 0 : next_wait;
      if (isGood(pose)) pose = solver.solve(out.body.markers, moments[i], pose.pose, hold, kReach, kSteps);
    } else if (wait > 0) {
      --wait;
    }
    if (!isGood(pose)) {
      ++out.report.lost;
      continue;
    }
    hold.last = pose.pose;
    last_t = t[i];
    RigPlacement X_WS;
    place(rig, pose.pose, X_WS);
    ledger.add(out.body, X_WS, moments[i]);
    jointsOf(rig, X_WS, humanmodel::JointState::kTracked, frame);
    const auto spread = spreadsOf(rig, solver, pose.rms);
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
      const humanmodel::JointState state =
          stateOf(static_cast<humanmodel::Joint>(j), observed[index(rig.carrier[j])], spread);
      frame.state[j] = state;
      if (state == humanmodel::JointState::kMissing)
        frame.p[j].setConstant(kNaN);
      else
        frame.spread[j] = observed[index(rig.carrier[j])] ? spread[j] : kAlone;
    }
  }
  ledger.write(out.body, out.report);
  writeBones(rig, out.report);
  return out;
}

}  // namespace abstand::tracking
