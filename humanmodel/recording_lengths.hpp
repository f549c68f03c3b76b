// Bone lengths of a recording, and a model that takes them over.
#pragma once

#include <span>

#include "humanmodel/human_model.hpp"

namespace abstand {

/// Median distance of two joints over at most 200 frames taken evenly, m. Nothing when they are never both
/// there.
std::optional<double> medianBone(std::span<const SkeletonFrame> frames, Joint a, Joint b);

/// Leg length (hip to knee to ankle) of the model over that of the recording, medians as above, mean of the
/// legs that are complete. Nothing without a complete leg.
std::optional<double> legRatio(const HumanModel& model, std::span<const SkeletonFrame> frames);

/// The same for one frame alone. No allocation.
std::optional<double> legRatio(const HumanModel& model, const SkeletonFrame& frame);

/// The options with the lengths of torso, head, upper arms, forearms, thighs and calves set so that the
/// model's bones are as long as the recording's: "the recording's own bone lengths rule". Left and right get
/// their mean. Girths stay, and so does a length that the user gave. Hands and feet stay, because formats end
/// them at different places (knuckle or finger tip, ball or toe tip), and so does the head without a head-top
/// joint. Throws UsageError for options that makeHuman() refuses.
HumanOptions withRecordingLengths(const HumanOptions& options, std::span<const SkeletonFrame> frames);

}  // namespace abstand
