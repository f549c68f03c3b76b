#include "app/analysis/analysis_feed.hpp"

namespace abstand::analysis {

using State = view::AnalysisNews::State;

bool AnalysisFeed::take(view::AnalysisNews& out) {
  const std::lock_guard lock(mutex_);
  if (!fresh_) return false;
  fresh_ = false;
  out = news_;
  news_.chunks.clear();
  news_.poses.clear();
  return true;
}

void AnalysisFeed::begin(std::shared_ptr<const margin::StoreLayout> layout) {
  const std::lock_guard lock(mutex_);
  news_.state = State::kRunning;
  news_.layout = std::move(layout);
  fresh_ = true;
}

void AnalysisFeed::tell(std::size_t done, std::size_t frames) {
  const std::lock_guard lock(mutex_);
  news_.done = done;
  news_.frames = frames;
  fresh_ = true;
}

void AnalysisFeed::add(std::shared_ptr<const margin::ClearanceChunk> chunk) {
  const std::lock_guard lock(mutex_);
  news_.chunks.push_back(std::move(chunk));
  fresh_ = true;
}

void AnalysisFeed::add(view::MomentPoses poses) {
  const std::lock_guard lock(mutex_);
  news_.poses.push_back(std::move(poses));
  fresh_ = true;
}

void AnalysisFeed::end(const std::string& problem) {
  const std::lock_guard lock(mutex_);
  news_.state = problem.empty() ? State::kDone : State::kFailed;
  news_.problem = problem;
  fresh_ = true;
}

}  // namespace abstand::analysis
