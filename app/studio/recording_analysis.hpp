// The analysis of what is shown, in step with the document.
#pragma once

#include <QTimer>
#include <memory>
#include <optional>

#include "app/analysis/analysis_runner.hpp"
#include "app/studio/live_port.hpp"
#include "ui/document/work.hpp"

namespace abstand::studio {

/// Runs again when the document changes the assumptions that distances depend on, or which pairs of people
/// and robots are checked. Changes that follow each other are one. GUI thread only.
class RecordingAnalysis {
 public:
  static constexpr int kGatherMs = 150;

  RecordingAnalysis();

  /// Starts; null without a request. What was under way is cancelled.
  std::unique_ptr<FeedPort> open(std::optional<analysis::AnalysisRequest> request, const ui::Work& work);
  void follow(const ui::Work& work);
  void close();
  /// Pairs of people and robots that `work` does not check.
  int leftOut() const { return static_cast<int>(left_out_.size()); }

 private:
  using Names = std::vector<std::pair<std::string, std::string>>;
  Names uncheckedOf(const ui::Work& work) const;
  std::shared_ptr<analysis::AnalysisFeed> start();

  analysis::AnalysisRunner runner_;
  std::optional<analysis::AnalysisRequest> request_;
  std::shared_ptr<FeedSlot> slot_;
  ui::WhatIfSettings settings_;
  Names left_out_;
  QTimer gather_;
};

}  // namespace abstand::studio
