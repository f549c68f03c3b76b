// The text file of `abstand pairs`: which pairs can collide at all, for people to review and to compare.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace abstand::study {

/// kSometimes pairs are checked; the others are not.
enum class PairVerdict {
  kAdjacent,   ///< they share a joint, or are one rigid body
  kNever,      ///< nothing found in any posture
  kAlways,     ///< overlapping in every posture
  kUser,       ///< somebody said so
  kSometimes,  ///< may collide
  kUndecided,  ///< the study was interrupted before it knew; never in a file
};
std::string verdictName(PairVerdict verdict);

/// One line of the file.
struct PairRow {
  PairVerdict verdict{PairVerdict::kSometimes};
  std::string a, b;      ///< names of bodies
  std::string evidence;  ///< for people: how it was found
  SourcePos pos;
};

/// Comment lines begin with #; then CSV: the header `verdict,a,b,...`, and a row a pair with at least these
/// three; the rest of a row is its evidence. Throws ParseError with line and column.
std::vector<PairRow> parsePairs(const std::string& text, const std::string& file);
std::vector<PairRow> loadPairs(const std::filesystem::path& file);

}  // namespace abstand::study
