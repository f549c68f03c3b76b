#include "app/studio/viewer_review.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ui/model/pair_class.hpp"

namespace abstand::studio {

ViewerReview::ViewerReview(std::shared_ptr<viewer::LiveRecord> record, const view::SceneOutline& outline)
    : record_(std::move(record)), moment_(moment::makeMoment(*record_->card())) {
  auto layout = std::make_shared<margin::StoreLayout>();
  std::map<int, std::uint16_t> parts, links;
  std::map<std::string, std::size_t> kinds;
  const auto indexOf = [&](auto& known, auto& bodies, int object, bool part) {
    const auto [at, fresh] = known.try_emplace(object, static_cast<std::uint16_t>(bodies.size()));
    if (!fresh) return at->second;
    const std::string& name = outline.objects[static_cast<std::size_t>(object)].name;
    const std::size_t kind =
        part ? kinds.try_emplace(name.substr(name.find('/') + 1), kinds.size()).first->second : 0;
    bodies.push_back({name, static_cast<std::size_t>(object), kind});
    return at->second;
  };
  for (std::size_t p = 0; p < outline.pairs.size(); ++p) {
    if (ui::pairClassOf(outline, outline.pairs[p]) != ui::PairClass::kPersonRobot) continue;
    auto [part, link] = outline.pairs[p];
    if (!outline.objects[static_cast<std::size_t>(part)].human) std::swap(part, link);
    layout->pairs.push_back(
        {indexOf(parts, layout->parts, part, true), indexOf(links, layout->links, link, false)});
    pairs_.push_back(p);
  }
  layout_ = std::move(layout);
  writer_ = std::make_unique<margin::ChunkWriter>(layout_, 0.0);
}

void ViewerReview::add(double t, const view::SceneSnapshot& moment) {
  samples_.clear();
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const view::PairSnapshot& pair = moment.pairs[pairs_[k]];
    const view::ObjectSnapshot& part = moment.objects[layout_->parts[layout_->pairs[k].part].object];
    const view::ObjectSnapshot& link = moment.objects[layout_->links[layout_->pairs[k].link].object];
    margin::PairSample sample;
    sample.uncertainty = part.pose_uncertainty + link.pose_uncertainty;
    sample.lost = pair.paused || scene::isPoseLost(part.pose_state) || scene::isPoseLost(link.pose_state);
    sample.distance = pair.result.distance;
    sample.clearance = pair.result.distance - pair.result.bound - sample.uncertainty;
    if (sample.lost || std::isnan(sample.clearance)) {
      sample.clearance = -kInfinity;
      sample.lost = true;
    }
    if (std::isnan(sample.distance)) sample.distance = 0.0;
    sample.between = sample.clearance;
    sample.braking = kInfinity;
    samples_.push_back(sample);
  }
  open_t_.push_back(t);
  open_samples_.insert(open_samples_.end(), samples_.begin(), samples_.end());
  if (auto chunk = writer_->add(t, samples_)) {
    chunks_.push_back(std::move(chunk));
    open_t_.clear();
    open_samples_.clear();
  }
  read_ = t;
  fresh_ = true;
}

bool ViewerReview::readNext() {
  if (!record_->copyAt(read_, read_ == -kInfinity ? 0 : 1, copy_) || !(copy_.t > read_)) return false;
  if (moment::readMoment(copy_.frame, moment_)) {
    add(copy_.t, moment_.shown);
  } else {
    read_ = copy_.t;
  }
  return true;
}

void ViewerReview::dropOld() {
  const double first = record_->span().first;
  const auto is_kept = [&](const auto& chunk) { return chunk->t(chunk->frames() - 1) >= first; };
  chunks_.erase(chunks_.begin(), std::find_if(chunks_.begin(), chunks_.end(), is_kept));
}

bool ViewerReview::takeNews(view::AnalysisNews& out) {
  using Clock = std::chrono::steady_clock;
  if (empty()) return false;
  const Clock::time_point begin = Clock::now();
  while (Clock::now() - begin < kBudget && readNext()) continue;
  if (!fresh_ || begin - told_ < std::chrono::duration<double>(kRenewal)) return false;
  fresh_ = false;
  told_ = begin;
  dropOld();
  out = {};
  out.state = view::AnalysisNews::State::kLive;
  out.layout = layout_;
  out.all = true;
  out.chunks = chunks_;
  if (!open_t_.empty())
    out.chunks.push_back(std::make_shared<margin::ClearanceChunk>(*layout_, open_t_, open_samples_, 0));
  return true;
}

}  // namespace abstand::studio
