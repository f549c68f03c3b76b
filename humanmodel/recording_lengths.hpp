// Bone lengths of a recording, and a model with these lengths.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "humanmodel/human_model.hpp"

namespace abstand::humanmodel {

/// Median distance (m) of two joints over at most 200 evenly spaced frames. nullopt if they never occur
/// together.
std::optional<double> medianBone(std::span<const SkeletonFrame> frames, Joint a, Joint b);

/// Leg length (hip to knee to ankle) of the model over that of the recording (medians as above), mean of the
/// complete legs. nullopt without a complete leg.
std::optional<double> legRatio(const HumanModel& model, std::span<const SkeletonFrame> frames);

/// The same for one frame. No allocation.
std::optional<double> legRatio(const HumanModel& model, const SkeletonFrame& frame);

/// Height of standing ankles above z = `floor`: 5 % quantile, over at most 200 evenly spaced frames, of the
/// lower ankle. nullopt if no ankle was recorded, and if the height is below 0 or above 0.25 m, as the floor
/// is elsewhere then.
std::optional<double> standingAnkle(std::span<const SkeletonFrame> frames, double floor);

/// A bone of a recording compared with the model. Lengths in m.
struct BoneLength {
  BodyPart part{};
  double median{0.0};    ///< of the recording, over at most 200 evenly spaced frames
  double spread{0.0};    ///< range from the 5 % to the 95 % quantile; 0 for rigid bones and exact joints
  double model{0.0};     ///< of the model at the fitted stature
  double residual{0.0};  ///< median - model
};

/// Stature of a person with the model's proportions and the recording's bone lengths.
struct LengthFit {
  double stature{0.0};         ///< m: mean over the bones
  double stature_spread{0.0};  ///< m: standard deviation over the bones
  double rms{0.0};             ///< m, of the residuals
  std::vector<BoneLength> bones;
};

/// Compares torso (hips to neck), head, upper arms, forearms, thighs and calves, both sides; the others end
/// at different places in different formats. The model's bones scale with its stature, independent of mass.
/// nullopt if the recording has none of these bones. Throws UsageError for options that makeHuman() refuses.
std::optional<LengthFit> fitLengths(const HumanOptions& options, std::span<const SkeletonFrame> frames);

/// Sets the lengths of torso, head, upper arms, forearms, thighs and calves so that the model's bones are as
/// long as the recording's. Left and right get their mean. Girths and lengths given by the user are kept, and
/// so are hands and feet, because formats end them at different places (knuckle or finger tip, ball or toe
/// tip), and the head without a head-top joint. Throws UsageError for options that makeHuman() refuses.
HumanOptions withRecordingLengths(const HumanOptions& options, std::span<const SkeletonFrame> frames);

}  // namespace abstand::humanmodel
