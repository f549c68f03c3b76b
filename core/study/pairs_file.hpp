// Text file of `abstand pairs`: which pairs can collide; for review and comparison.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/error.hpp"

namespace abstand::study {

/// Pairs with kSometimes are checked; all others are not.
enum class PairVerdict {
  kAdjacent,   ///< they share a joint, or are part of one rigid body
  kNever,      ///< no collision found in any posture
  kAlways,     ///< overlapping in every posture
  kUser,       ///< set by the user
  kSometimes,  ///< may collide
  kUndecided,  ///< the study was interrupted before a decision; never in a file
};
std::string verdictName(PairVerdict verdict);

/// One line of the file.
struct PairRow {
  PairVerdict verdict{PairVerdict::kSometimes};
  std::string a, b;      ///< names of bodies
  std::string evidence;  ///< how it was found; informative
  SourcePos pos;
};

/// Parses comment lines, which begin with #, and CSV: the header `verdict,a,b,...`, and one row for each pair
/// with at least these three; the rest of a row is its evidence. Throws ParseError with line and column.
std::vector<PairRow> parsePairs(const std::string& text, const std::string& file);
std::vector<PairRow> loadPairs(const std::filesystem::path& file);

}  // namespace abstand::study
