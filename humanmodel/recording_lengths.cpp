// Medians over a recording's bones.
#include "humanmodel/recording_lengths.hpp"

#include <algorithm>
#include <cmath>

#include "humanmodel/torso_frame.hpp"

namespace abstand {
namespace {

using enum Joint;
constexpr std::size_t kMostFrames = 200;
constexpr double kShortestBone = 1e-3;  // m; shorter ones are joints that a format repeats

struct Leg {
  Joint hip, knee, ankle;
};
constexpr Leg kLegs[] = {{kHipLeft, kKneeLeft, kAnkleLeft}, {kHipRight, kKneeRight, kAnkleRight}};

/// Median of what `measure` finds in the sampled frames.
template <class Measure>
std::optional<double> medianOf(std::span<const SkeletonFrame> frames, Measure measure) {
  std::vector<double> found;
  const std::size_t samples = std::min(frames.size(), kMostFrames);
  found.reserve(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const std::size_t at = samples == 1 ? 0 : i * (frames.size() - 1) / (samples - 1);
    const std::optional<double> value = measure(frames[at]);
    if (value && std::isfinite(*value) && *value > kShortestBone) found.push_back(*value);
  }
  if (found.empty()) return std::nullopt;
  const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
  std::nth_element(found.begin(), middle, found.end());
  return *middle;
}

/// `bone` gives the recording's distance of two joints.
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

std::optional<double> medianTrunk(std::span<const SkeletonFrame> frames) {
  return medianOf(frames, [](const SkeletonFrame& frame) -> std::optional<double> {
    const std::optional<Vector3d> hips = hipCentre(frame);
    if (!hips || !frame.has(kNeck)) return std::nullopt;
    return (frame[kNeck] - *hips).norm();
  });
}

}  // namespace

std::optional<double> medianBone(std::span<const SkeletonFrame> frames, Joint a, Joint b) {
  return medianOf(frames, [&](const SkeletonFrame& frame) -> std::optional<double> {
    if (!frame.has(a) || !frame.has(b)) return std::nullopt;
    return (frame[a] - frame[b]).norm();
  });
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

HumanOptions withRecordingLengths(const HumanOptions& options, std::span<const SkeletonFrame> frames) {
  const HumanModel model = makeHuman(options);

  // Median bones of both sides, gathered by kind of part.
  std::array<double, kPartKindCount> sum{};
  std::array<int, kPartKindCount> count{};
  for (const HumanPart& part : model.parts) {
    const PartKind kind = kindOf(part.part);
    if (kind == PartKind::kHand || kind == PartKind::kFoot) continue;
    const std::optional<double> bone =
        kind == PartKind::kTorso ? medianTrunk(frames) : medianBone(frames, part.proximal, part.distal);
    if (!bone) continue;
    sum[index(kind)] += *bone;
    ++count[index(kind)];
  }

  HumanOptions fitted = options;
  for (const HumanPart& part : model.parts) {
    const std::size_t kind = index(kindOf(part.part));
    if (count[kind] == 0) continue;
    PartOverride& wish = fitted.overrides[part.part];
    if (wish.length) continue;
    const double bone = (part.p_proximal - part.p_distal).norm();
    wish.length = part.length * (sum[kind] / count[kind]) / bone;
  }
  return fitted;
}

}  // namespace abstand
