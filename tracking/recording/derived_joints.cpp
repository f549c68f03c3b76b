#include "tracking/recording/derived_joints.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/quantile.hpp"

namespace abstand::tracking {
namespace {

using humanmodel::Joint;
using humanmodel::SkeletonFrame;

constexpr double kHeadPerTrunk = 0.5;  // approximately the mean of the conventions in data/joint_maps, 0.3 to
                                       // 0.7
constexpr double kHalfHeadPerTrunk = 0.065 / 0.288;
constexpr double kHandPerForearm = 0.108 / 0.146;
constexpr double kCosOfStrayHeadTop = 0.5;  // 60 degrees
constexpr double kCosOfSole = 0.9;          // 25 degrees
constexpr double kBallAheadPerCalf = 0.45, kBallBelowPerCalf = 0.039 / 0.246;
/// In units of the file; nearer points define no direction.
constexpr double kSmallestLength = 1e-9;

bool has(const SkeletonFrame& f, Joint a, Joint b) { return f.has(a) && f.has(b); }

bool anyHas(const std::vector<SkeletonFrame>& frames, Joint j) {
  return std::any_of(frames.begin(), frames.end(), [j](const SkeletonFrame& f) { return f.has(j); });
}

Vector3d direction(const Vector3d& from, const Vector3d& to) {
  const Vector3d d = to - from;
  const double length = d.norm();
  return length > kSmallestLength ? Vector3d(d / length) : Vector3d::Constant(kNaN);
}

void setInferred(SkeletonFrame& f, Joint j, const Vector3d& p) {
  if (p.allFinite()) f.set(j, p, humanmodel::JointState::kInferred);
}

void middle(SkeletonFrame& f, Joint j, Joint a, Joint b) {
  if (has(f, a, b)) setInferred(f, j, 0.5 * (f[a] + f[b]));
}

double medianLength(const SkeletonFrame& rest, const std::vector<SkeletonFrame>& frames, Joint a, Joint b) {
  std::vector<double> lengths;
  for (const auto i : sampleIndices(frames.size()))
    if (has(frames[i], a, b)) lengths.push_back((frames[i][b] - frames[i][a]).norm());
  if (lengths.empty() && has(rest, a, b)) lengths.push_back((rest[b] - rest[a]).norm());
  return nearestQuantile(std::move(lengths), 0.5);
}

/// Cosine of the angle at b between a-b and b-c, in the median frame; NaN if undefined.
double medianCosine(const std::vector<SkeletonFrame>& frames, Joint a, Joint b, Joint c) {
  std::vector<double> cosines;
  for (const auto i : sampleIndices(frames.size())) {
    const auto& f = frames[i];
    if (!has(f, a, b) || !f.has(c)) continue;
    const double cosine = direction(f[a], f[b]).dot(direction(f[b], f[c]));
    if (std::isfinite(cosine)) cosines.push_back(cosine);
  }
  return nearestQuantile(std::move(cosines), 0.5);
}

/// Applies a rule to the rest pose and to every frame.
template <typename Rule>
void toAll(SkeletonFrame& rest, std::vector<SkeletonFrame>& frames, Rule rule) {
  rule(rest);
  for (auto& f : frames) rule(f);
}

/// Derives the joints of a recording in order of their dependencies.
class JointDerivation {
 public:
  JointDerivation(SkeletonFrame& rest, std::vector<SkeletonFrame>& frames) : rest_(rest), frames_(frames) {}

  void midpoints() {
    const auto between = [this](Joint j, Joint a, Joint b) {
      derive(j, [=](SkeletonFrame& f) { middle(f, j, a, b); });
    };
    between(Joint::kPelvis, Joint::kHipLeft, Joint::kHipRight);
    between(Joint::kThorax, Joint::kShoulderLeft, Joint::kShoulderRight);
    between(Joint::kNeck, Joint::kShoulderLeft, Joint::kShoulderRight);
    between(Joint::kSpine, Joint::kPelvis, Joint::kThorax);
  }

  void head(HeadPoint point) {
    straightenHeadTop();
    const double trunk = medianLength(rest_, frames_, Joint::kPelvis, Joint::kNeck);
    const bool is_middle = point == HeadPoint::kMiddle;
    derive(Joint::kHeadTop, [trunk, is_middle](SkeletonFrame& f) {
      if (!has(f, Joint::kNeck, Joint::kHead)) return;
      const Vector3d& from = f[is_middle ? Joint::kHead : Joint::kNeck];
      const double length = (is_middle ? kHalfHeadPerTrunk : kHeadPerTrunk) * trunk;
      setInferred(f, Joint::kHeadTop, from + length * direction(f[Joint::kNeck], f[Joint::kHead]));
    });
    if (is_middle) return;
    toAll(rest_, frames_, [](SkeletonFrame& f) {
      if (has(f, Joint::kHead, Joint::kHeadTop))
        f.set(Joint::kHead, 0.5 * (f[Joint::kHead] + f[Joint::kHeadTop]),
              f.state[static_cast<std::size_t>(Joint::kHead)]);
    });
  }

  void hand(Joint elbow, Joint wrist, Joint hand_joint) {
    const double length = kHandPerForearm * medianLength(rest_, frames_, elbow, wrist);
    derive(hand_joint, [=](SkeletonFrame& f) {
      if (has(f, elbow, wrist)) setInferred(f, hand_joint, f[wrist] + length * direction(f[elbow], f[wrist]));
    });
  }

  void toe(Joint knee, Joint ankle, Joint toe_joint) {
    const double calf = medianLength(rest_, frames_, knee, ankle);
    dropSole(knee, ankle, toe_joint);
    derive(toe_joint, [=](SkeletonFrame& f) {
      if (!has(f, knee, ankle) || !has(f, Joint::kHipLeft, Joint::kHipRight)) return;
      const Vector3d up = direction(f[ankle], f[knee]);
      const Vector3d forward = (f[Joint::kHipLeft] - f[Joint::kHipRight]).cross(up);
      setInferred(f, toe_joint,
                  f[ankle] + calf * (kBallAheadPerCalf * direction(Vector3d::Zero(), forward) -
                                     kBallBelowPerCalf * up));
    });
  }

  /// One sentence on each joint that was derived or moved.
  std::vector<std::string> sentences() const {
    std::vector<std::string> all = moved_;
    if (!made_.empty()) all.push_back("not in the file and derived from other joints: " + made_);
    return all;
  }

 private:
  /// Applies a rule for a joint that no frame has.
  template <typename Rule>
  void derive(Joint j, Rule rule) {
    if (anyHas(frames_, j)) return;
    toAll(rest_, frames_, rule);
    const bool is_inner = j == Joint::kSpine || j == Joint::kThorax;  // no part ends there
    if (anyHas(frames_, j) && !is_inner)
      made_ += (made_.empty() ? "" : ", ") + std::string(humanmodel::jointName(j));
  }

  void straightenHeadTop() {
    if (!(medianCosine(frames_, Joint::kNeck, Joint::kHead, Joint::kHeadTop) < kCosOfStrayHeadTop)) return;
    moved_.push_back(
        "the end site of the head is not above it: the top of the head is placed on the line of the "
        "neck");
    toAll(rest_, frames_, [](SkeletonFrame& f) {
      if (!f.has(Joint::kNeck) || !has(f, Joint::kHead, Joint::kHeadTop)) return;
      const double length = (f[Joint::kHeadTop] - f[Joint::kHead]).norm();
      setInferred(f, Joint::kHeadTop, f[Joint::kHead] + length * direction(f[Joint::kNeck], f[Joint::kHead]));
    });
  }

  /// Removes a toe that is the end of the sole.
  void dropSole(Joint knee, Joint ankle, Joint toe) {
    if (!(medianCosine(frames_, knee, ankle, toe) > kCosOfSole)) return;
    moved_.push_back("the end of the foot lies below the ankle: " + std::string(humanmodel::jointName(toe)) +
                     " is derived instead");
    toAll(rest_, frames_, [toe](SkeletonFrame& f) {
      f.set(toe, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
    });
  }

  SkeletonFrame& rest_;
  std::vector<SkeletonFrame>& frames_;
  std::vector<std::string> moved_;
  std::string made_;  ///< names of joints
};

}  // namespace

std::vector<std::size_t> sampleIndices(std::size_t count, std::size_t max_count) {
  std::vector<std::size_t> indices;
  const std::size_t n = std::min(count, max_count);
  for (std::size_t i = 0; i < n; ++i) indices.push_back(i * count / n);
  return indices;
}

std::vector<std::string> deriveJoints(humanmodel::SkeletonFrame& rest,
                                      std::vector<humanmodel::SkeletonFrame>& frames, HeadPoint head) {
  JointDerivation derivation(rest, frames);
  derivation.midpoints();
  derivation.head(head);
  derivation.hand(Joint::kElbowLeft, Joint::kWristLeft, Joint::kHandLeft);
  derivation.hand(Joint::kElbowRight, Joint::kWristRight, Joint::kHandRight);
  derivation.toe(Joint::kKneeLeft, Joint::kAnkleLeft, Joint::kToeLeft);
  derivation.toe(Joint::kKneeRight, Joint::kAnkleRight, Joint::kToeRight);
  return derivation.sentences();
}

}  // namespace abstand::tracking
