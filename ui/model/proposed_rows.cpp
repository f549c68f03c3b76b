// Proposed margins as rows of the window, in words.
#include "ui/model/proposed_rows.hpp"

#include <algorithm>
#include <cmath>

#include "ui/model/event_text.hpp"
#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

constexpr double kLargestRow = 2.0;  // m, of a row

/// m: of the links that are checked with a part.
double leastLinkMargin(const margin::StoreLayout& layout, std::size_t part,
                       const std::vector<double>& margins) {
  double least = kInfinity;
  for (const auto& pair : layout.pairs)
    if (pair.part == part) least = std::min(least, margins[layout.links[pair.link].object]);
  return std::isfinite(least) ? least : 0.0;
}

QString mm(double metres) { return lengthText(metres, 0); }

}  // namespace

QString proposalProblem(const RecordingReview& review) {
  using State = view::AnalysisNews::State;
  if (!review.available())
    return tr("Margins are proposed from a recording of a person and a robot; the scene has none.");
  if (review.state() == State::kFailed)
    return tr("Nothing is proposed, because the analysis of the recording failed: %1").arg(review.problem());
  if (review.state() == State::kLive)
    return tr("Margins are proposed from a recording, not from the moments of a running server.");
  if (review.state() != State::kDone || !review.store() || review.store()->empty())
    return tr("Nothing is proposed yet: the analysis of the recording is at %1 %.")
        .arg(static_cast<int>(100.0 * review.progress()));
  return {};
}

std::vector<ProposedRow> proposedRows(const margin::ClearanceStore& store, const std::vector<double>& margins,
                                      const std::vector<bool>& locked, const margin::MarginOptions& options) {
  std::vector<ProposedRow> rows;
  for (const margin::PartProposal& proposal : margin::proposeMargins(store, options)) {
    for (const std::size_t part : proposal.parts) {
      ProposedRow row;
      row.object = static_cast<int>(store.layout().parts[part].object);
      row.part = static_cast<int>(part);
      row.proposal = proposal;
      row.name = partText(store, part);
      if (proposal.decided_by) row.link = linkText(store, proposal.decided_by->link);
      const auto object = static_cast<std::size_t>(row.object);
      const double links = leastLinkMargin(store.layout(), part, margins);
      const double needed = std::max(0.0, proposal.margin - links);
      if (!proposal.judged) {
        row.sentence =
            tr("never seen, or never so far away that the robot could have stopped in time; the row stays.");
      } else if (!std::isfinite(proposal.margin)) {
        row.sentence = tr("no margin would do; the row stays.");
      } else if (needed > kLargestRow) {
        row.sentence = tr("%1, more than a row can have; the row stays.").arg(mm(proposal.margin));
      } else {
        row.sentence = links > 0.0 ? tr("%1: %2 of this row and at least %3 of the links.")
                                         .arg(mm(proposal.margin), mm(needed), mm(links))
                                   : tr("%1.").arg(mm(proposal.margin));
        if (locked[object])
          row.sentence += margins[object] < needed - 1e-9
                              ? tr(" The row is locked at %1, which is too small.").arg(mm(margins[object]))
                              : tr(" The row is locked at %1.").arg(mm(margins[object]));
        else
          row.metres = needed;
      }
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace abstand::ui
