// Whose markers are read from a file with several subjects.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tracking/recording/recording.hpp"
#include "tracking/recording/subject_facts.hpp"

namespace abstand::tracking {

/// The subject whose markers are used.
struct SubjectChoice {
  std::string prefix;              ///< of its labels, without the last ':'; empty: they have none
  std::vector<std::string> names;  ///< all names of the file, empty for markers of others
  std::string warning;             ///< names the others; empty: there are none
};

/// The label "A:LASI" is of the subject A; labels without a prefix are of a subject of their own. Uses the
/// subject with most labels that marker sets and joint maps know, then with most labels, then the first.
/// Labels that the user's joint map names with their prefix are kept. Throws ParseError for maps and sets.
SubjectChoice chooseSubject(std::span<const std::string> names, const RecordingOptions& options);

/// What the file says of that subject: by the prefix of its labels or its name. With several subjects, but
/// labels that do not tell them apart, it is the first, with a warning.
StatedSubject statedOf(const SubjectChoice& choice, std::span<const StatedSubject> subjects);

}  // namespace abstand::tracking
