#include "tracking/recording/derived_joints.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/quantile.hpp"

namespace abstand::tracking {
namespace {

constexpr double kHeadPerTrunk = 0.5;  // about the mean of the conventions in data/joint_maps, 0.3 to 0.7
constexpr double kHalfHeadPerTrunk = 0.065 / 0.288;
constexpr double kHandPerForearm = 0.108 / 0.146;
constexpr double kCosOfStrayHeadTop = 0.5;  // 60 degrees
constexpr double kCosOfSole = 0.9;          // 25 degrees
constexpr double kBallAheadPerCalf = 0.45, kBallBelowPerCalf = 0.039 / 0.246;
/// Points nearer to each other than this, in units of the file, have no direction.
constexpr double kSmallestLength = 1e-9;

bool has(const humanmodel::SkeletonFrame& f, humanmodel::Joint a, humanmodel::Joint b) {
  return f.has(a) && f.has(b);
}

bool anyHas(const std::vector<humanmodel::SkeletonFrame>& frames, humanmodel::Joint j) {
  return std::any_of(frames.begin(), frames.end(),
                     [j](const humanmodel::SkeletonFrame& f) { return f.has(j); });
}

Vector3d direction(const Vector3d& from, const Vector3d& to) {
  const Vector3d d = to - from;
  const double length = d.norm();
  return length > kSmallestLength ? Vector3d(d / length) : Vector3d::Constant(kNaN);
}

void setInferred(humanmodel::SkeletonFrame& f, humanmodel::Joint j, const Vector3d& p) {
  if (p.allFinite()) f.set(j, p, humanmodel::JointState::kInferred);
}

void middle(humanmodel::SkeletonFrame& f, humanmodel::Joint j, humanmodel::Joint a, humanmodel::Joint b) {
  if (has(f, a, b)) setInferred(f, j, 0.5 * (f[a] + f[b]));
}

double medianLength(const humanmodel::SkeletonFrame& rest,
                    const std::vector<humanmodel::SkeletonFrame>& frames, humanmodel::Joint a,
                    humanmodel::Joint b) {
  std::vector<double> lengths;
  for (const auto i : sampleIndices(frames.size()))
    if (has(frames[i], a, b)) lengths.push_back((frames[i][b] - frames[i][a]).norm());
  if (lengths.empty() && has(rest, a, b)) lengths.push_back((rest[b] - rest[a]).norm());
  return nearestQuantile(std::move(lengths), 0.5);
}

/// The cosine of the angle at b on the way from a over b to c, in the median frame; NaN where there is none.
double medianCosine(const std::vector<humanmodel::SkeletonFrame>& frames, humanmodel::Joint a,
                    humanmodel::Joint b, humanmodel::Joint c) {
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
void toAll(humanmodel::SkeletonFrame& rest, std::vector<humanmodel::SkeletonFrame>& frames, Rule rule) {
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

std::vector<std::string> deriveJoints(humanmodel::SkeletonFrame& rest,
                                      std::vector<humanmodel::SkeletonFrame>& frames, HeadPoint head) {
  std::vector<std::string> sentences;
  std::string made;
  const auto derive = [&](humanmodel::Joint j, auto rule) {
    if (anyHas(frames, j)) return;
    toAll(rest, frames, rule);
    const bool is_inner =
        j == humanmodel::Joint::kSpine || j == humanmodel::Joint::kThorax;  // no part ends there
    if (anyHas(frames, j) && !is_inner)
      made += (made.empty() ? "" : ", ") + std::string(humanmodel::jointName(j));
  };

  derive(humanmodel::Joint::kPelvis, [](humanmodel::SkeletonFrame& f) {
    middle(f, humanmodel::Joint::kPelvis, humanmodel::Joint::kHipLeft, humanmodel::Joint::kHipRight);
  });
  derive(humanmodel::Joint::kThorax, [](humanmodel::SkeletonFrame& f) {
    middle(f, humanmodel::Joint::kThorax, humanmodel::Joint::kShoulderLeft,
           humanmodel::Joint::kShoulderRight);
  });
  derive(humanmodel::Joint::kNeck, [](humanmodel::SkeletonFrame& f) {
    middle(f, humanmodel::Joint::kNeck, humanmodel::Joint::kShoulderLeft, humanmodel::Joint::kShoulderRight);
  });
  derive(humanmodel::Joint::kSpine, [](humanmodel::SkeletonFrame& f) {
    middle(f, humanmodel::Joint::kSpine, humanmodel::Joint::kPelvis, humanmodel::Joint::kThorax);
  });

  if (medianCosine(frames, humanmodel::Joint::kNeck, humanmodel::Joint::kHead, humanmodel::Joint::kHeadTop) <
      kCosOfStrayHeadTop) {
    sentences.push_back(
        "the end site of the head does not lie above it: the top of the head is put onto the line of the "
        "neck");
    toAll(rest, frames, [](humanmodel::SkeletonFrame& f) {
      if (!f.has(humanmodel::Joint::kNeck) || !has(f, humanmodel::Joint::kHead, humanmodel::Joint::kHeadTop))
        return;
      const double length = (f[humanmodel::Joint::kHeadTop] - f[humanmodel::Joint::kHead]).norm();
      setInferred(f, humanmodel::Joint::kHeadTop,
                  f[humanmodel::Joint::kHead] +
                      length * direction(f[humanmodel::Joint::kNeck], f[humanmodel::Joint::kHead]));
    });
  }
  const double trunk = medianLength(rest, frames, humanmodel::Joint::kPelvis, humanmodel::Joint::kNeck);
  const bool is_middle = head == HeadPoint::kMiddle;
  derive(humanmodel::Joint::kHeadTop, [trunk, is_middle](humanmodel::SkeletonFrame& f) {
    if (!has(f, humanmodel::Joint::kNeck, humanmodel::Joint::kHead)) return;
    const Vector3d& from = f[is_middle ? humanmodel::Joint::kHead : humanmodel::Joint::kNeck];
    const double length = (is_middle ? kHalfHeadPerTrunk : kHeadPerTrunk) * trunk;
    setInferred(f, humanmodel::Joint::kHeadTop,
                from + length * direction(f[humanmodel::Joint::kNeck], f[humanmodel::Joint::kHead]));
  });
  toAll(rest, frames, [is_middle](humanmodel::SkeletonFrame& f) {
    if (has(f, humanmodel::Joint::kHead, humanmodel::Joint::kHeadTop) && !is_middle)
      f.set(humanmodel::Joint::kHead, 0.5 * (f[humanmodel::Joint::kHead] + f[humanmodel::Joint::kHeadTop]),
            f.state[static_cast<std::size_t>(humanmodel::Joint::kHead)]);
  });

  const auto hand = [&](humanmodel::Joint elbow, humanmodel::Joint wrist, humanmodel::Joint hand_joint) {
    const double length = kHandPerForearm * medianLength(rest, frames, elbow, wrist);
    derive(hand_joint, [=](humanmodel::SkeletonFrame& f) {
      if (has(f, elbow, wrist)) setInferred(f, hand_joint, f[wrist] + length * direction(f[elbow], f[wrist]));
    });
  };
  hand(humanmodel::Joint::kElbowLeft, humanmodel::Joint::kWristLeft, humanmodel::Joint::kHandLeft);
  hand(humanmodel::Joint::kElbowRight, humanmodel::Joint::kWristRight, humanmodel::Joint::kHandRight);

  const auto toe = [&](humanmodel::Joint knee, humanmodel::Joint ankle, humanmodel::Joint toe_joint) {
    const double calf = medianLength(rest, frames, knee, ankle);
    if (medianCosine(frames, knee, ankle, toe_joint) > kCosOfSole) {
      sentences.push_back("the end of the foot lies below the ankle: " +
                          std::string(humanmodel::jointName(toe_joint)) + " is derived instead");
      toAll(rest, frames, [&](humanmodel::SkeletonFrame& f) {
        f.set(toe_joint, Vector3d::Constant(kNaN), humanmodel::JointState::kMissing);
      });
    }
    derive(toe_joint, [=](humanmodel::SkeletonFrame& f) {
      if (!has(f, knee, ankle) || !has(f, humanmodel::Joint::kHipLeft, humanmodel::Joint::kHipRight)) return;
      const Vector3d up = direction(f[ankle], f[knee]);
      const Vector3d forward = (f[humanmodel::Joint::kHipLeft] - f[humanmodel::Joint::kHipRight]).cross(up);
      setInferred(f, toe_joint,
                  f[ankle] + calf * (kBallAheadPerCalf * direction(Vector3d::Zero(), forward) -
                                     kBallBelowPerCalf * up));
    });
  };
  toe(humanmodel::Joint::kKneeLeft, humanmodel::Joint::kAnkleLeft, humanmodel::Joint::kToeLeft);
  toe(humanmodel::Joint::kKneeRight, humanmodel::Joint::kAnkleRight, humanmodel::Joint::kToeRight);

  if (!made.empty()) sentences.push_back("not in the file and derived from other joints: " + made);
  return sentences;
}

}  // namespace abstand::tracking
