// Contact limits of the body regions that occur in a recording, as result files keep them.
#pragma once

#include <string>
#include <vector>

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// The regions of the predicted contacts of approaches and frames, in the order of the table, each once; of
/// its pressures each has the smallest one, which counts.
std::vector<contact::RegionLimits> occurringRegions(const PassResult& pass,
                                                    const contact::ContactLimits& limits);

/// Over all recordings, each once, by name. They have one table of limits (mergeResults()).
std::vector<contact::RegionLimits> occurringRegions(const std::vector<TunedRecording>& recordings);

/// One line of tab-separated fields: numbers in SI with sources and doubts, and of the pressures the smallest
/// one, which counts. A region at which contact is excluded has no factor.
std::string regionLine(const contact::RegionLimits& region);
/// Throws ParseError for a damaged line. Only the fields of the line are set.
contact::RegionLimits regionOf(const std::string& line, const std::string& file);

/// A predicted contact beside its limits.
struct JudgedContact {
  contact::RegionLimits region;
  contact::PredictedContact contact;  ///< at the speed and masses of the approach's contact
  double allowed_pressure{0.0};       ///< Pa; 0: excluded
};
/// Empty if no contact was predicted for the approach.
std::optional<JudgedContact> judgedContact(const TunedRecording& recording, const Approach& approach);

}  // namespace abstand::tune
