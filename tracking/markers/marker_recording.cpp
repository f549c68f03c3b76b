#include "tracking/markers/marker_recording.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/data_folder.hpp"
#include "core/base/error.hpp"
#include "core/math/quantile.hpp"
#include "tracking/markers/marker_solution.hpp"
#include "tracking/markers/stature_check.hpp"
#include "tracking/recording/derived_joints.hpp"

namespace abstand::tracking {
namespace {

using enum RigSegment;

/// m; larger coordinates are invalid.
constexpr double kFarthest = 1e4;
/// Heights of markers above the feet, as shares of stature: on the head, the chest, the pelvis.
constexpr double kHeadHeight = 0.90, kChestHeight = 0.72, kPelvisHeight = 0.53;

/// m; statures by the heights of markers that cast no doubt on a unit: those of a sitting person are small.
constexpr StatureRange kByMarkers{0.7, 2.6};

/// Distance of the hip joint centres from the middle: 0.36 of the distance of the iliac spines (about 0.24 m
/// at 1.75 m) (Bell, Pedersen, Brand 1990, J. Biomech. 23). The model's hips are farther apart, below the
/// trochanters.
constexpr double kHipFromMiddle = 0.36 * 0.24 / 1.75;

/// Shoulder joint centres lie under the acromion markers, which the sets place at this share of half the
/// chest's breadth. The model's lie below the outer ends of the acromia, some 35 mm farther out.
constexpr double kShoulderPerChest = 1.06;

/// Rig of mean stature with hip and shoulder joints at these distances.
const BodyRig& usualRig() {
  static const BodyRig rig = [] {
    BodyRig made = makeRig(humanmodel::makeHuman({}));
    const double hip = kHipFromMiddle * made.height;
    const double shoulder = kShoulderPerChest * halfExtent(made[kChest].shape, 1);
    for (const auto& [segment, joint, y] :
         {std::tuple(kThighLeft, humanmodel::Joint::kHipLeft, hip),
          std::tuple(kThighRight, humanmodel::Joint::kHipRight, -hip),
          std::tuple(kUpperArmLeft, humanmodel::Joint::kShoulderLeft, shoulder),
          std::tuple(kUpperArmRight, humanmodel::Joint::kShoulderRight, -shoulder)}) {
      made.parts[index(segment)].p_parent.y() = y;
      made.p_joint[static_cast<std::size_t>(joint)] = made.parts[index(segment)].p_parent;
    }
    return made;
  }();
  return rig;
}

bool isOf(RigSegment s, std::initializer_list<RigSegment> any) {
  return std::find(any.begin(), any.end(), s) != any.end();
}

/// Mean of the markers on some segments; nullopt if none is visible.
std::optional<Vector3d> meanOn(const MarkerMatch& match, const std::vector<Vector3d>& places,
                               std::initializer_list<RigSegment> segments) {
  Vector3d sum = Vector3d::Zero();
  int count = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!isOf(match.markers[k].segment, segments) || !places[k].allFinite()) continue;
    sum += places[k];
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

/// Sets the markers of each joint for the report: those on the segments that meet there.
void nameMarkers(const MarkerMatch& match, RawRecording& raw) {
  const BodyRig& rig = usualRig();
  raw.match = JointMatch{};
  raw.match.joint.fill(-1);
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    std::vector<int> points;
    for (const auto& m : match.markers)
      if (m.segment == rig.carrier[j]) points.insert(points.end(), m.points.begin(), m.points.end());
    if (points.empty()) continue;
    raw.match.joint[j] = static_cast<int>(raw.joints.size() + raw.match.means.size());
    raw.match.means.push_back(std::move(points));
  }
}

}  // namespace

MarkerTrack::MarkerTrack(std::span<const std::string> names, const RecordingOptions& options,
                         const std::string& file) {
  const bool is_named = options.marker_set != "auto";
  const auto sets = is_named ? std::vector<MarkerSet>{loadMarkerSet(options.marker_set)}
                             : loadMarkerSets(dataFolder() / "marker_sets");
  match_ = chooseMarkerSet(sets, usualRig(), names);
  if (is_named && !match_) {
    const auto found = matchMarkers(sets.front(), usualRig(), names).markers.size();
    throw ParseError({file}, "found " + std::to_string(found) + " of the " +
                                 std::to_string(sets.front().markers.size()) + " markers of the set '" +
                                 sets.front().name + "', expected at least six on three segments");
  }
  if (!match_) {
    reason_ = "no marker set finds six of its markers on three segments in this file";
    return;
  }
  reason_ = std::to_string(match_->markers.size()) + " of its " +
            std::to_string(match_->markers.size() + match_->not_found.size()) + " markers are in the file";
  if (is_named) reason_ += ", given by the user";
}

void MarkerTrack::add(const PointFrame& frame) {
  ABSTAND_CHECK(hasSet());
  auto& places = places_.emplace_back();
  places.reserve(match_->markers.size());
  for (const auto& marker : match_->markers) {
    Vector3d sum = Vector3d::Zero();
    for (const int i : marker.points)
      sum += frame.state[static_cast<std::size_t>(i)] == humanmodel::JointState::kMissing
                 ? Vector3d::Constant(kNaN)
                 : frame.p[static_cast<std::size_t>(i)];
    const Vector3d mean = sum / static_cast<double>(marker.points.size());
    places.push_back(mean.allFinite() ? mean : Vector3d::Constant(kNaN));
  }
}

std::vector<humanmodel::SkeletonFrame> MarkerTrack::heightsOf() const {
  std::vector<humanmodel::SkeletonFrame> frames;
  for (const auto i : sampleIndices(places_.size())) {
    humanmodel::SkeletonFrame f;
    std::optional<Vector3d> low = meanOn(*match_, places_[i], {kFootLeft, kFootRight});
    if (!low) low = meanOn(*match_, places_[i], {kCalfLeft, kCalfRight});
    if (!low) low = meanOn(*match_, places_[i], {kPelvis});
    std::optional<Vector3d> high = meanOn(*match_, places_[i], {kHead});
    if (!high) high = meanOn(*match_, places_[i], {kChest});
    if (!high) high = meanOn(*match_, places_[i], {kPelvis});
    if (low) f.set(humanmodel::Joint::kPelvis, *low);
    if (high) f.set(humanmodel::Joint::kThorax, *high);
    frames.push_back(f);
  }
  return frames;
}

UpChoice MarkerTrack::chooseUpOf(const RecordingOptions& options) const {
  return chooseUp(options.up, {}, heightsOf());
}

/// Of the heights of markers, in units of the file.
std::optional<double> MarkerTrack::statureOf() const {
  const auto has = [&](RigSegment s) {
    return std::any_of(match_->markers.begin(), match_->markers.end(),
                       [s](const FoundMarker& m) { return m.segment == s; });
  };
  const double share = has(kHead) ? kHeadHeight : has(kChest) ? kChestHeight : kPelvisHeight;
  std::vector<double> heights;
  for (const auto& f : heightsOf())
    if (f.has(humanmodel::Joint::kPelvis) && f.has(humanmodel::Joint::kThorax))
      heights.push_back((f[humanmodel::Joint::kThorax] - f[humanmodel::Joint::kPelvis]).norm() / share);
  std::optional<double> stature;
  if (!heights.empty()) stature = nearestQuantile(std::move(heights), 0.9);
  if (stature && !(*stature > 0.0)) stature.reset();
  return stature;
}

MarkerReport MarkerTrack::solveInto(RawRecording& raw, const RecordingOptions& options) const {
  ABSTAND_CHECK(hasSet() && places_.size() == raw.frames.size());
  const bool is_stated = raw.unit && options.units == "auto";
  const std::optional<double> height = statureOf();
  UnitChoice unit =
      is_stated ? *raw.unit : chooseUnit(options.units, height, std::nullopt, raw.subject.height);
  const std::string doubt = height ? doubtOfUnit(unit, *height, kByMarkers) : std::string();
  if (is_stated) unit.warning = doubt;
  const UpChoice up = raw.up && options.up == "auto" ? *raw.up : chooseUpOf(options);
  // Exchanged left and right, by axes or by names, is a mirrored body.
  Matrix3d R_WF = rotationToZUp(up.axis);
  if (options.mirror != "none") R_WF.row(1) *= -1.0;

  std::vector<MarkerPlaces> moments(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i)
    for (const Vector3d& p_F : places_[i]) {
      const Vector3d p_W = unit.scale * (R_WF * p_F);
      const bool good = p_W.allFinite() && p_W.cwiseAbs().maxCoeff() < kFarthest;
      moments[i].push_back(good ? p_W : Vector3d::Constant(kNaN));
    }
  std::vector<double> t;
  for (const auto& f : raw.frames) t.push_back(f.t);
  const std::optional<double> stature =
      raw.subject.height > 0.0 ? std::optional(raw.subject.height) : std::nullopt;
  MarkerSolution solution = solveMarkers(usualRig(), match_->markers, t, moments, stature);
  MarkerReport report = std::move(solution.report);
  report.set = match_->set;
  report.reason = reason_;
  const std::size_t seen = raw.frames.size() - report.unseen;
  if (2 * report.lost > seen || seen == 0) {
    MarkerReport none;
    none.reason = "the set '" + match_->set + "' shows no body in " + std::to_string(report.lost) + " of " +
                  std::to_string(seen) + " frames with its markers" + (doubt.empty() ? "" : "; " + doubt);
    if (is_stated) raw.unit = unit;
    return none;
  }
  if (stature)
    if (std::string wrong = doubtOfStature({usualRig(), match_->markers, t, moments, *stature});
        !wrong.empty())
      raw.warnings.push_back({0, std::move(wrong)});
  for (auto& f : solution.frames)
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      if (f.state[j] != humanmodel::JointState::kMissing) {
        f.p[j] = R_WF.transpose() * f.p[j] / unit.scale;
        f.spread[j] /= unit.scale;
      }
  raw.frames = std::move(solution.frames);
  raw.rest = humanmodel::SkeletonFrame{};
  raw.unit = unit;
  raw.unit_is_guess = !is_stated;
  raw.up = up;
  raw.is_canonical = true;
  nameMarkers(*match_, raw);
  return report;
}

}  // namespace abstand::tracking
