// Runs an analysis to its end.
#pragma once

#include "app/analysis/analysis_runner.hpp"
#include "core/margin/margin_review.hpp"

namespace abstand::testing {

/// What a finished analysis gave.
struct StoredRecording {
  std::optional<margin::ClearanceStore> store;
  view::AnalysisNews last;
};

inline void takeNews(analysis::AnalysisFeed& feed, StoredRecording& stored) {
  view::AnalysisNews news;
  if (!feed.take(news)) return;
  if (!stored.store && news.layout) stored.store.emplace(news.layout);
  for (auto& chunk : news.chunks) stored.store->add(std::move(chunk));
  stored.last = std::move(news);
}

/// On this thread.
inline StoredRecording analysed(const analysis::AnalysisRequest& request) {
  analysis::AnalysisFeed feed;
  analysis::runAnalysis(request, feed);
  StoredRecording stored;
  takeNews(feed, stored);
  return stored;
}

}  // namespace abstand::testing
