// Bone lengths of a recording, and a model that takes them over.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Median distance of two joints over at most 200 frames taken evenly, m. Nothing when they are never both
/// there.
std::optional<double> medianBone(std::span<const SkeletonFrame> frames, Joint a, Joint b);

/// Leg length (hip to knee to ankle) of the model over that of the recording, medians as above, mean of the
/// legs that are complete. Nothing without a complete leg.
std::optional<double> legRatio(const HumanModel& model, std::span<const SkeletonFrame> frames);

/// The same for one frame alone. No allocation.
std::optional<double> legRatio(const HumanModel& model, const SkeletonFrame& frame);

/// Height above z = `floor` of the ankles on the ground: the 5 % quantile, over at most 200 frames taken
/// evenly, of the lower ankle. Nothing when no ankle was recorded, and when the height is below 0 or above
/// 0.25 m: the floor of such a recording lies elsewhere.
std::optional<double> standingAnkle(std::span<const SkeletonFrame> frames, double floor);

/// A bone of a recording beside that of the model. Lengths in m.
struct BoneLength {
  BodyPart part{};
  double median{0.0};    ///< of the recording, over at most 200 frames taken evenly
  double spread{0.0};    ///< from the 5 % to the 95 % quantile; of rigid bones and exact joints 0
  double model{0.0};     ///< of the model at the fitted stature
  double residual{0.0};  ///< median - model
};

/// How tall a person of the model's proportions is whose bones are as long as the recording's.
struct LengthFit {
  double stature{0.0};         ///< m: the mean of what each bone says
  double stature_spread{0.0};  ///< m: standard deviation of what the bones say
  double rms{0.0};             ///< m, of the residuals
  std::vector<BoneLength> bones;
};

/// Compares torso (hips to neck), head, upper arms, forearms, thighs and calves, both sides; the others end
/// at different places in different formats. Bones of the model grow with its height, whatever its mass.
/// Nothing where the recording has none of these bones. Throws UsageError for options that makeHuman()
/// refuses.
std::optional<LengthFit> fitLengths(const HumanOptions& options, std::span<const SkeletonFrame> frames);

/// The options with the lengths of torso, head, upper arms, forearms, thighs and calves set so that the
/// model's bones are as long as the recording's: "the recording's own bone lengths rule". Left and right get
/// their mean. Girths stay, and so does a length that the user gave. Hands and feet stay, because formats end
/// them at different places (knuckle or finger tip, ball or toe tip), and so does the head without a head-top
/// joint. Throws UsageError for options that makeHuman() refuses.
HumanOptions withRecordingLengths(const HumanOptions& options, std::span<const SkeletonFrame> frames);

}  // namespace abstand::humanmodel
