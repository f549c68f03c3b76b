// The analysis of a made-up recording: clearances in closed form.
#pragma once

#include <cmath>
#include <functional>

#include "tests/ui/fake_session.hpp"
#include "ui/model/analysis_port.hpp"

namespace abstand::ui {

/// Gives frames when it is told to. Parts are those of people, links are bodies of the group "arm".
class FakeAnalysis : public AnalysisPort {
 public:
  /// m, of a part at a frame to the first link; the next ones are 50 mm farther each. NaN: not seen.
  using Clearance = std::function<double(std::size_t part, std::size_t frame)>;

  FakeAnalysis(const view::SceneOutline& outline, Clearance clearance)
      : clearance_(std::move(clearance)), period_(outline.frame_period), start_(outline.start) {
    auto layout = std::make_shared<margin::StoreLayout>();
    for (std::size_t i = 0; i < outline.objects.size(); ++i) {
      const auto& object = outline.objects[i];
      if (object.human) layout->parts.push_back({object.name, i, layout->parts.size()});
      if (object.group == "arm") layout->links.push_back({object.name, i, 0});
    }
    for (std::uint16_t k = 0; k < layout->parts.size(); ++k)
      for (std::uint16_t l = 0; l < layout->links.size(); ++l) layout->pairs.push_back({k, l});
    layout_ = layout;
    frames_ = static_cast<std::size_t>(std::lround((outline.end - outline.start) / period_)) + 1;
    writer_.emplace(layout_, 0.0);
    news_.layout = layout_;
    news_.frames = frames_;
    news_.state = view::AnalysisNews::State::kRunning;
  }

  const margin::StoreLayout& layout() const { return *layout_; }
  std::size_t frames() const { return frames_; }
  double t(std::size_t frame) const { return start_ + static_cast<double>(frame) * period_; }
  double clearance(std::size_t part, std::size_t frame) const { return clearance_(part, frame); }

  /// Runs on to this frame; a chunk comes when it is full or when all is done.
  void run(std::size_t frames) {
    for (; news_.done < std::min(frames, frames_); ++news_.done) {
      std::vector<margin::PairSample> samples;
      for (const auto& [part, link] : layout_->pairs) samples.push_back(sample(part, link));
      hand(writer_->add(t(news_.done), samples));
    }
    if (news_.done == frames_) {
      hand(writer_->finish());
      news_.state = view::AnalysisNews::State::kDone;
    }
    fresh_ = true;
  }
  void runAll() { run(frames_); }

  bool takeNews(view::AnalysisNews& out) override {
    if (!fresh_) return false;
    fresh_ = false;
    out = news_;
    news_.chunks.clear();
    return true;
  }

 private:
  margin::PairSample sample(std::size_t part, std::size_t link) const {
    const double nearest = clearance_(part, news_.done);
    const bool seen = !std::isnan(nearest);
    margin::PairSample s;
    s.clearance = seen ? nearest + 0.05 * static_cast<double>(link) : -kInfinity;
    s.distance = (seen ? s.clearance : 1.0) + 0.01;
    s.uncertainty = seen ? 0.005 : kInfinity;
    s.between = news_.done + 1 < frames_ ? s.clearance - 0.001 : kInfinity;
    s.braking = seen ? s.clearance - 0.01 : -kInfinity;
    s.closing = 0.5;
    return s;
  }
  void hand(std::shared_ptr<const margin::ClearanceChunk> chunk) {
    if (chunk) news_.chunks.push_back(std::move(chunk));
  }

  Clearance clearance_;
  double period_, start_;
  std::size_t frames_{0};
  std::shared_ptr<const margin::StoreLayout> layout_;
  std::optional<margin::ChunkWriter> writer_;
  view::AnalysisNews news_;
  bool fresh_{true};
};

/// Part k is nearest at 1 s + 0.5 s k, 20 mm + 10 mm k, and goes away from there at 0.5 m/s.
inline double valley(std::size_t part, double t) {
  return 0.02 + 0.01 * static_cast<double>(part) + 0.5 * std::abs(t - 1.0 - 0.5 * static_cast<double>(part));
}

}  // namespace abstand::ui
