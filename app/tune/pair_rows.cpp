#include "app/tune/pair_rows.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tune {
namespace {

constexpr std::size_t kBlockRows = 2048;

}  // namespace

PairRows::PairRows(const TunedRecording& recording, const margin::ClearanceTrack& body, bool speeds)
    : recording_(recording), body_(body), file_(recording.file), speeds_(speeds) {}

bool PairRows::next() {
  const std::size_t at = begun_ ? index_ + 1 : 0;
  if (at >= recording_.frames) return false;
  begun_ = true;
  index_ = at;
  if (index_ >= first_ + rows_) readBlock();
  return true;
}

void PairRows::readBlock() {
  first_ = index_;
  rows_ = std::min(kBlockRows, recording_.frames - first_);
  clearance_ = file_.rows("distance", first_, rows_, pairs());
  const std::vector<double> bound = file_.rows("bound", first_, rows_, pairs());
  const std::vector<double> uncertainty = file_.rows("uncertainty", first_, rows_, pairs());
  robot_speed_.resize(clearance_.size());
  person_speed_.resize(clearance_.size());
  for (std::size_t i = 0; i < clearance_.size(); ++i) {
    // NaN counts as unknown, which is never safe.
    const double clearance = clearance_[i] - bound[i] - uncertainty[i];
    clearance_[i] = std::isnan(clearance) ? -kInfinity : clearance;
  }
  if (!speeds_) return;
  const std::vector<double> speeds = file_.rows("pair_speeds", first_, rows_, 2 * pairs());
  for (std::size_t i = 0; i < clearance_.size(); ++i) {
    robot_speed_[i] = std::isnan(speeds[2 * i]) ? kInfinity : speeds[2 * i];
    person_speed_[i] = std::isnan(speeds[2 * i + 1]) ? kInfinity : speeds[2 * i + 1];
  }
}

margin::PairFrame PairRows::frame() const {
  const std::size_t at = (index_ - first_) * pairs();
  return {body_.t[index_],
          {clearance_.data() + at, pairs()},
          {robot_speed_.data() + at, pairs()},
          {person_speed_.data() + at, pairs()},
          body_.between[index_],
          body_.braking[index_]};
}

}  // namespace abstand::tune
