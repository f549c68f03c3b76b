// Medians of bone lengths over a recording.
#include "humanmodel/recording_lengths.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/quantile.hpp"
#include "humanmodel/torso_frame.hpp"

namespace abstand::humanmodel {
namespace {

using enum Joint;
constexpr std::size_t kMaxFrames = 200;
constexpr double kShortestBone = 1e-3;       // m; shorter ones are joints duplicated by a format
constexpr double kLow = 0.05, kHigh = 0.95;  // quantiles of a bone's spread
constexpr double kGroundQuantile = 0.05;     // some frames may be invalid or below a sloping floor
constexpr double kHighestAnkle = 0.25;       // m; a tall person's is 0.09, plus a thick sole or a marker

struct Leg {
  Joint hip, knee, ankle;
};
constexpr Leg kLegs[] = {{kHipLeft, kKneeLeft, kAnkleLeft}, {kHipRight, kKneeRight, kAnkleRight}};

/// Quantile (0 to 1) of the values of `measure` over the sampled frames.
template <class Measure>
std::optional<double> quantileOf(std::span<const SkeletonFrame> frames, double quantile, Measure measure) {
  std::vector<double> found;
  const std::size_t samples = std::min(frames.size(), kMaxFrames);
  found.reserve(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const std::size_t at = samples == 1 ? 0 : i * (frames.size() - 1) / (samples - 1);
    const std::optional<double> value = measure(frames[at]);
    if (value && std::isfinite(*value)) found.push_back(*value);
  }
  if (found.empty()) return std::nullopt;
  return upperQuantile(std::move(found), quantile);
}

/// Quantile of a bone's length; coinciding joints are ignored.
template <class Measure>
std::optional<double> lengthAt(std::span<const SkeletonFrame> frames, double quantile, Measure measure) {
  return quantileOf(frames, quantile, [&](const SkeletonFrame& frame) -> std::optional<double> {
    const std::optional<double> length = measure(frame);
    if (!length || !(*length > kShortestBone)) return std::nullopt;
    return length;
  });
}

/// `bone` returns the recording's distance of two joints.
template <class Bone>
std::optional<double> ratioOfLegs(const HumanModel& model, Bone bone) {
  double of_model = 0.0, of_recording = 0.0;
  for (const Leg& leg : kLegs) {
    const std::optional<double> thigh = bone(leg.hip, leg.knee), calf = bone(leg.knee, leg.ankle);
    if (!thigh || !calf) continue;
    of_recording += *thigh + *calf;
    of_model += (model.rest[leg.hip] - model.rest[leg.knee]).norm() +
                (model.rest[leg.knee] - model.rest[leg.ankle]).norm();
  }
  if (!(of_recording > kShortestBone)) return std::nullopt;
  return of_model / of_recording;
}

std::optional<double> boneAt(std::span<const SkeletonFrame> frames, double quantile, Joint a, Joint b) {
  return lengthAt(frames, quantile, [&](const SkeletonFrame& frame) -> std::optional<double> {
    if (!frame.has(a) || !frame.has(b)) return std::nullopt;
    return (frame[a] - frame[b]).norm();
  });
}

std::optional<double> trunkAt(std::span<const SkeletonFrame> frames, double quantile) {
  return lengthAt(frames, quantile, [](const SkeletonFrame& frame) -> std::optional<double> {
    const std::optional<Vector3d> hips = hipCentre(frame);
    if (!hips || !frame.has(kNeck)) return std::nullopt;
    return (frame[kNeck] - *hips).norm();
  });
}

/// Length of a part in the recording; nullopt for hands and feet.
std::optional<double> partAt(std::span<const SkeletonFrame> frames, double quantile, const HumanPart& part) {
  const PartKind kind = kindOf(part.part);
  if (kind == PartKind::kHand || kind == PartKind::kFoot) return std::nullopt;
  if (kind == PartKind::kTorso) return trunkAt(frames, quantile);
  return boneAt(frames, quantile, part.proximal, part.distal);
}

}  // namespace

std::optional<double> medianBone(std::span<const SkeletonFrame> frames, Joint a, Joint b) {
  return boneAt(frames, 0.5, a, b);
}

std::optional<double> legRatio(const HumanModel& model, std::span<const SkeletonFrame> frames) {
  return ratioOfLegs(model, [&](Joint a, Joint b) { return medianBone(frames, a, b); });
}

std::optional<double> legRatio(const HumanModel& model, const SkeletonFrame& frame) {
  return ratioOfLegs(model, [&](Joint a, Joint b) -> std::optional<double> {
    if (!frame.has(a) || !frame.has(b)) return std::nullopt;
    return (frame[a] - frame[b]).norm();
  });
}

std::optional<double> standingAnkle(std::span<const SkeletonFrame> frames, double floor) {
  const std::optional<double> z =
      quantileOf(frames, kGroundQuantile, [](const SkeletonFrame& frame) -> std::optional<double> {
        std::optional<double> lower;
        for (const Leg& leg : kLegs)
          if (frame.has(leg.ankle)) lower = std::min(lower.value_or(kInfinity), frame[leg.ankle].z());
        return lower;
      });
  if (!z || !(*z - floor >= 0.0 && *z - floor <= kHighestAnkle)) return std::nullopt;
  return *z - floor;
}

std::optional<LengthFit> fitLengths(const HumanOptions& options, std::span<const SkeletonFrame> frames) {
  const HumanModel model = makeHuman(options);
  LengthFit fit;
  std::vector<double> statures;
  for (const HumanPart& part : model.parts) {
    const std::optional<double> median = partAt(frames, 0.5, part);
    if (!median) continue;
    BoneLength bone;
    bone.part = part.part;
    bone.median = *median;
    bone.spread = *partAt(frames, kHigh, part) - *partAt(frames, kLow, part);
    bone.model = (part.p_proximal - part.p_distal).norm();
    statures.push_back(model.height * bone.median / bone.model);
    fit.bones.push_back(bone);
  }
  if (statures.empty()) return std::nullopt;
  const auto count = static_cast<double>(statures.size());
  for (const double s : statures) fit.stature += s / count;
  double squares = 0.0;
  for (std::size_t i = 0; i < statures.size(); ++i) {
    BoneLength& bone = fit.bones[i];
    bone.model *= fit.stature / model.height;
    bone.residual = bone.median - bone.model;
    fit.rms += bone.residual * bone.residual / count;
    squares += (statures[i] - fit.stature) * (statures[i] - fit.stature) / count;
  }
  fit.rms = std::sqrt(fit.rms);
  fit.stature_spread = std::sqrt(squares);
  return fit;
}

HumanOptions withRecordingLengths(const HumanOptions& options, std::span<const SkeletonFrame> frames) {
  const HumanModel model = makeHuman(options);

  // Median bones of both sides, summed by kind of part.
  std::array<double, kPartKindCount> sum{};
  std::array<int, kPartKindCount> count{};
  for (const HumanPart& part : model.parts) {
    const PartKind kind = kindOf(part.part);
    const std::optional<double> bone = partAt(frames, 0.5, part);
    if (!bone) continue;
    sum[index(kind)] += *bone;
    ++count[index(kind)];
  }

  HumanOptions fitted = options;
  for (const HumanPart& part : model.parts) {
    const std::size_t kind = index(kindOf(part.part));
    if (count[kind] == 0) continue;
    PartOverride& requested = fitted.overrides[part.part];
    if (requested.length) continue;
    const double bone = (part.p_proximal - part.p_distal).norm();
    requested.length = part.length * (sum[kind] / count[kind]) / bone;
  }
  return fitted;
}

}  // namespace abstand::humanmodel
