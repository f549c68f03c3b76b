#include "app/studio/recording_analysis.hpp"

#include <algorithm>

namespace abstand::studio {

RecordingAnalysis::RecordingAnalysis() {
  gather_.setSingleShot(true);
  gather_.setInterval(kGatherMs);
  QObject::connect(&gather_, &QTimer::timeout, [this] {
    if (slot_) slot_->feed = start();
  });
}

std::unique_ptr<FeedPort> RecordingAnalysis::open(std::optional<analysis::AnalysisRequest> request,
                                                  const ui::Work& work) {
  close();
  if (!request) return nullptr;
  request_ = std::move(request);
  settings_ = work.what_if;
  left_out_ = uncheckedOf(work);
  slot_ = std::make_shared<FeedSlot>();
  slot_->feed = start();
  return std::make_unique<FeedPort>(slot_);
}

void RecordingAnalysis::close() {
  gather_.stop();
  runner_.stop();
  request_.reset();
  slot_.reset();
  left_out_.clear();
}

void RecordingAnalysis::follow(const ui::Work& work) {
  if (!request_) return;
  Names left_out = uncheckedOf(work);
  if (work.what_if.sameAnalysis(settings_) && left_out == left_out_) return;
  settings_ = work.what_if;
  left_out_ = std::move(left_out);
  runner_.stop();
  gather_.start();
}

/// In the order of the request.
RecordingAnalysis::Names RecordingAnalysis::uncheckedOf(const ui::Work& work) const {
  Names unchecked;
  const auto is_removed = [&](const std::string& a, const std::string& b) {
    const auto found = work.moved.find({QString::fromStdString(a), QString::fromStdString(b)});
    return found != work.moved.end() && found->isEmpty();
  };
  for (const auto& [part, link] : request_->watched)
    if (is_removed(part, link) || is_removed(link, part)) unchecked.emplace_back(part, link);
  return unchecked;
}

std::shared_ptr<analysis::AnalysisFeed> RecordingAnalysis::start() {
  if (left_out_.size() == request_->watched.size()) {
    auto feed = std::make_shared<analysis::AnalysisFeed>();
    feed->end("found no pair of a person and a robot that is checked, expected one or more");
    return feed;
  }
  analysis::AnalysisRequest request = *request_;
  request.left_out = left_out_;
  request.pass.limit = settings_.limit;
  request.pass.braking.reaction_time = settings_.reaction_time;
  request.pass.braking.deceleration = settings_.deceleration;
  request.pass.calibration_error = settings_.calibration_error;
  request.pass.latency = settings_.latency;
  return runner_.start(std::move(request));
}

}  // namespace abstand::studio
