#include "tracking/recording/derived_joints.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"

namespace abstand {
namespace {

constexpr double kHeadPerTrunk = 0.5;  // about the mean of the conventions in data/joint_maps, 0.3 to 0.7
constexpr double kHalfHeadPerTrunk = 0.065 / 0.288;
constexpr double kHandPerForearm = 0.108 / 0.146;
constexpr double kCosOfStrayHeadTop = 0.5;  // 60 degrees
constexpr double kCosOfSole = 0.9;          // 25 degrees
constexpr double kBallAheadPerCalf = 0.45, kBallBelowPerCalf = 0.039 / 0.246;
/// Points nearer to each other than this, in units of the file, have no direction.
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
  if (p.allFinite()) f.set(j, p, JointState::kInferred);
}

void middle(SkeletonFrame& f, Joint j, Joint a, Joint b) {
  if (has(f, a, b)) setInferred(f, j, 0.5 * (f[a] + f[b]));
}

double medianLength(const SkeletonFrame& rest, const std::vector<SkeletonFrame>& frames, Joint a, Joint b) {
  std::vector<double> lengths;
  for (const auto i : sampleIndices(frames.size()))
    if (has(frames[i], a, b)) lengths.push_back((frames[i][b] - frames[i][a]).norm());
  if (lengths.empty() && has(rest, a, b)) lengths.push_back((rest[b] - rest[a]).norm());
  return lengths.empty() ? kNaN : quantile(lengths, 0.5);
}

/// The cosine of the angle at b on the way from a over b to c, in the median frame; NaN where there is none.
double medianCosine(const std::vector<SkeletonFrame>& frames, Joint a, Joint b, Joint c) {
  std::vector<double> cosines;
  for (const auto i : sampleIndices(frames.size())) {
    const auto& f = frames[i];
    if (!has(f, a, b) || !f.has(c)) continue;
    const double cosine = direction(f[a], f[b]).dot(direction(f[b], f[c]));
    if (std::isfinite(cosine)) cosines.push_back(cosine);
  }
  return cosines.empty() ? kNaN : quantile(cosines, 0.5);
}

/// Applies a rule to the rest pose and to every frame.
template <typename Rule>
void toAll(SkeletonFrame& rest, std::vector<SkeletonFrame>& frames, Rule rule) {
  rule(rest);
  for (auto& f : frames) rule(f);
}

}  // namespace

std::vector<std::size_t> sampleIndices(std::size_t count, std::size_t most) {
  std::vector<std::size_t> indices;
  const std::size_t n = std::min(count, most);
  for (std::size_t i = 0; i < n; ++i) indices.push_back(i * count / n);
  return indices;
}

double quantile(std::vector<double> values, double q) {
  ABSTAND_CHECK(!values.empty());
  const auto k = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

std::vector<std::string> deriveJoints(SkeletonFrame& rest, std::vector<SkeletonFrame>& frames,
                                      HeadPoint head) {
  std::vector<std::string> sentences;
  std::string made;
  const auto derive = [&](Joint j, auto rule) {
    if (anyHas(frames, j)) return;
    toAll(rest, frames, rule);
    const bool is_inner = j == Joint::kSpine || j == Joint::kThorax;  // no part ends there
    if (anyHas(frames, j) && !is_inner) made += (made.empty() ? "" : ", ") + std::string(jointName(j));
  };

  derive(Joint::kPelvis,
         [](SkeletonFrame& f) { middle(f, Joint::kPelvis, Joint::kHipLeft, Joint::kHipRight); });
  derive(Joint::kThorax,
         [](SkeletonFrame& f) { middle(f, Joint::kThorax, Joint::kShoulderLeft, Joint::kShoulderRight); });
  derive(Joint::kNeck,
         [](SkeletonFrame& f) { middle(f, Joint::kNeck, Joint::kShoulderLeft, Joint::kShoulderRight); });
  derive(Joint::kSpine, [](SkeletonFrame& f) { middle(f, Joint::kSpine, Joint::kPelvis, Joint::kThorax); });

  if (medianCosine(frames, Joint::kNeck, Joint::kHead, Joint::kHeadTop) < kCosOfStrayHeadTop) {
    sentences.push_back(
        "the end site of the head does not lie above it: the top of the head is put onto the line of the "
        "neck");
    toAll(rest, frames, [](SkeletonFrame& f) {
      if (!f.has(Joint::kNeck) || !has(f, Joint::kHead, Joint::kHeadTop)) return;
      const double length = (f[Joint::kHeadTop] - f[Joint::kHead]).norm();
      setInferred(f, Joint::kHeadTop, f[Joint::kHead] + length * direction(f[Joint::kNeck], f[Joint::kHead]));
    });
  }
  const double trunk = medianLength(rest, frames, Joint::kPelvis, Joint::kNeck);
  const bool is_middle = head == HeadPoint::kMiddle;
  derive(Joint::kHeadTop, [trunk, is_middle](SkeletonFrame& f) {
    if (!has(f, Joint::kNeck, Joint::kHead)) return;
    const Vector3d& from = f[is_middle ? Joint::kHead : Joint::kNeck];
    const double length = (is_middle ? kHalfHeadPerTrunk : kHeadPerTrunk) * trunk;
    setInferred(f, Joint::kHeadTop, from + length * direction(f[Joint::kNeck], f[Joint::kHead]));
  });
  toAll(rest, frames, [is_middle](SkeletonFrame& f) {
    if (has(f, Joint::kHead, Joint::kHeadTop) && !is_middle)
      f.set(Joint::kHead, 0.5 * (f[Joint::kHead] + f[Joint::kHeadTop]),
            f.state[static_cast<std::size_t>(Joint::kHead)]);
  });

  const auto hand = [&](Joint elbow, Joint wrist, Joint hand_joint) {
    const double length = kHandPerForearm * medianLength(rest, frames, elbow, wrist);
    derive(hand_joint, [=](SkeletonFrame& f) {
      if (has(f, elbow, wrist)) setInferred(f, hand_joint, f[wrist] + length * direction(f[elbow], f[wrist]));
    });
  };
  hand(Joint::kElbowLeft, Joint::kWristLeft, Joint::kHandLeft);
  hand(Joint::kElbowRight, Joint::kWristRight, Joint::kHandRight);

  const auto toe = [&](Joint knee, Joint ankle, Joint toe_joint) {
    const double calf = medianLength(rest, frames, knee, ankle);
    if (medianCosine(frames, knee, ankle, toe_joint) > kCosOfSole) {
      sentences.push_back("the end of the foot lies below the ankle: " + std::string(jointName(toe_joint)) +
                          " is derived instead");
      toAll(rest, frames,
            [&](SkeletonFrame& f) { f.set(toe_joint, Vector3d::Constant(kNaN), JointState::kMissing); });
    }
    derive(toe_joint, [=](SkeletonFrame& f) {
      if (!has(f, knee, ankle) || !has(f, Joint::kHipLeft, Joint::kHipRight)) return;
      const Vector3d up = direction(f[ankle], f[knee]);
      const Vector3d forward = (f[Joint::kHipLeft] - f[Joint::kHipRight]).cross(up);
      setInferred(f, toe_joint,
                  f[ankle] + calf * (kBallAheadPerCalf * direction(Vector3d::Zero(), forward) -
                                     kBallBelowPerCalf * up));
    });
  };
  toe(Joint::kKneeLeft, Joint::kAnkleLeft, Joint::kToeLeft);
  toe(Joint::kKneeRight, Joint::kAnkleRight, Joint::kToeRight);

  if (!made.empty()) sentences.push_back("not in the file and derived from other joints: " + made);
  return sentences;
}

}  // namespace abstand
