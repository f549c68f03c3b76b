// Clearances of the moments that a server sent, for the lanes.
#pragma once

#include <chrono>
#include <memory>

#include "app/moment/moment_packet.hpp"
#include "app/viewer/live_record.hpp"
#include "core/margin/clearance_chunk.hpp"
#include "ui/model/analysis_port.hpp"

namespace abstand::studio {

/// Reads the kept moments, the last ten minutes, one after the other as they arrive. All clearances are those
/// of a moment: what was between two of them is not known, nor how a robot would have braked. A pair that the
/// server did not check, and one with a pose that is stale or was rejected, has no known clearance. GUI
/// thread only; a call takes kBudget at most.
class ViewerReview final : public ui::AnalysisPort {
 public:
  static constexpr double kRenewal = 0.5;  ///< s of wall time, between two news
  static constexpr std::chrono::milliseconds kBudget{4};

  ViewerReview(std::shared_ptr<viewer::LiveRecord> record, const view::SceneOutline& outline);

  /// There is no pair of a person and a robot.
  bool empty() const { return layout_->pairs.empty(); }
  bool takeNews(view::AnalysisNews& out) override;

 private:
  bool readNext();
  void add(double t, const view::SceneSnapshot& moment);
  void dropOld();

  std::shared_ptr<viewer::LiveRecord> record_;
  std::shared_ptr<const margin::StoreLayout> layout_;
  std::vector<std::size_t> pairs_;  ///< of the outline, in the order of the layout
  std::unique_ptr<margin::ChunkWriter> writer_;
  std::vector<std::shared_ptr<const margin::ClearanceChunk>> chunks_;  ///< full ones
  std::vector<double> open_t_;                                         ///< s, of the chunk that is not full
  std::vector<margin::PairSample> samples_, open_samples_;
  moment::Moment moment_;
  viewer::LiveRecord::Copy copy_;
  double read_{-kInfinity};  ///< s, of the newest moment that was read
  bool fresh_{false};
  std::chrono::steady_clock::time_point told_{};
};

}  // namespace abstand::studio
