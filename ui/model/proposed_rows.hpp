// Proposed margins as rows of the window, in words.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/margin/proposed_margin.hpp"
#include "ui/model/recording_review.hpp"

namespace abstand::ui {

/// What a proposal means for the row of one body part.
struct ProposedRow {
  int object{0};                 ///< of the outline
  std::optional<double> metres;  ///< m, for the row; none: it stays
  margin::PartProposal proposal;
  QString name;      ///< of the part
  QString sentence;  ///< margin and what it is made of, without the moment that decides it
  QString link;      ///< that decides it
  int part{0};       ///< of the store
};

/// Why there is nothing to propose; empty: there is.
QString proposalProblem(const RecordingReview& review);

/// A part's row gets what its smallest safe margin needs beyond the least margin of the links that are
/// checked with it, whose rows stay.
/// @param margins  m, of each object
std::vector<ProposedRow> proposedRows(const margin::ClearanceStore& store, const std::vector<double>& margins,
                                      const std::vector<bool>& locked, const margin::MarginOptions& options);

}  // namespace abstand::ui
