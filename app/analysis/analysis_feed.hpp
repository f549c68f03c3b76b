// From the thread of an analysis to the one that shows it.
#pragma once

#include <atomic>
#include <mutex>

#include "core/view/analysis_news.hpp"

namespace abstand::analysis {

/// One thread fills it, any other takes from it. Nobody waits longer than a copy takes.
class AnalysisFeed {
 public:
  /// Moves what is new since the last call to `out`; false, and `out` untouched, for nothing.
  bool take(view::AnalysisNews& out);
  /// The analysis ends soon after, and tells no more.
  void cancel() { cancelled_ = true; }
  bool cancelled() const { return cancelled_; }

  void begin(std::shared_ptr<const margin::StoreLayout> layout);
  void tell(std::size_t done, std::size_t frames);
  void add(std::shared_ptr<const margin::ClearanceChunk> chunk);
  void add(view::MomentPoses poses);
  /// An empty problem: all is done.
  void end(const std::string& problem);

 private:
  std::mutex mutex_;
  view::AnalysisNews news_;
  bool fresh_{true};
  std::atomic<bool> cancelled_{false};
};

}  // namespace abstand::analysis
