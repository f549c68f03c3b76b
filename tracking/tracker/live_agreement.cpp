#include "tracking/tracker/live_agreement.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

bool holdsNow(const CameraFault& fault) { return fault.until == kInfinity; }

}  // namespace

LiveAgreement::LiveAgreement(std::span<const DepthCamera> cameras, const TrackedPerson::Options& options,
                             bool aside)
    : cameras_(cameras.begin(), cameras.end()),
      agreement_(cameras_, options),
      views_(cameras_),
      pace_(cameras.size()) {
  if (aside) thread_ = std::thread([this] { run(); });
}

LiveAgreement::~LiveAgreement() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  came_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void LiveAgreement::copy(const DepthMoment& moment, std::span<const DepthImage* const> known, Work& work) {
  const std::size_t count = moment.frames.size();
  work.t = moment.t;
  work.frames.resize(count);
  work.known.resize(count);
  work.has_frame.assign(count, false);
  work.has_known.assign(count, false);
  for (std::size_t c = 0; c < count; ++c) {
    if (!moment.is_new[c] || !moment.frames[c]) continue;
    work.has_frame[c] = true;
    work.frames[c] = *moment.frames[c];
    work.has_known[c] = known[c] != nullptr;
    if (known[c]) work.known[c] = *known[c];
  }
}

void LiveAgreement::offer(const DepthMoment& moment, std::span<const DepthImage* const> known) {
  if (!pace_.isDue(moment.t, moment.is_new)) return;
  {
    const std::lock_guard lock(mutex_);
    if (error_) std::rethrow_exception(error_);
    if (is_ready_) return;
  }
  pace_.note(moment.t, moment.is_new);
  copy(moment, known, work_);
  if (!thread_.joinable()) return compare(work_);
  {
    const std::lock_guard lock(mutex_);
    is_ready_ = true;
  }
  came_.notify_one();
}

bool LiveAgreement::isBusy() {
  const std::lock_guard lock(mutex_);
  return is_ready_;
}

/// Not while mutex_ is held.
void LiveAgreement::compare(const Work& work) {
  DepthMoment moment;
  moment.t = work.t;
  for (std::size_t c = 0; c < work.frames.size(); ++c) {
    moment.frames.push_back(work.has_frame[c] ? &work.frames[c] : nullptr);
    moment.is_new.push_back(work.has_frame[c]);
  }
  views_.see(moment, [&](double, const DepthCamera& camera) -> const DepthImage* {
    const auto c = static_cast<std::size_t>(&camera - cameras_.data());
    return work.has_known[c] ? &work.known[c] : nullptr;
  });
  agreement_.note(moment, views_);
  agreement_.see(moment, views_);
  if (work.t < next_judged_) return;
  next_judged_ = work.t + kJudged;
  agreement_.forgetBefore(work.t - kRemembered);
  std::vector<CameraFault> found = agreement_.faults();
  const std::lock_guard lock(mutex_);
  found_ = std::move(found);
  judged_at_ = work.t;
  is_known_ = false;
}

void LiveAgreement::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    came_.wait(lock, [this] { return ends_ || is_ready_; });
    if (ends_) return;
    lock.unlock();
    std::exception_ptr error;
    try {
      compare(work_);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    error_ = error;
    is_ready_ = false;
    if (error_) return;
  }
}

std::span<const CameraFault> LiveAgreement::faults() {
  const std::lock_guard lock(mutex_);
  if (!is_known_) note(found_, judged_at_);
  is_known_ = true;
  return faults_;
}

/// Who is wrong was known best when it began: what jumped is forgotten in time.
void LiveAgreement::note(const std::vector<CameraFault>& found, double t) {
  std::vector<bool> goes_on(faults_.size(), false);
  for (const CameraFault& now : found) {
    if (!holdsNow(now) || (now.kind != CameraFault::Kind::kApart && now.kind != CameraFault::Kind::kLate))
      continue;
    const auto isThis = [&](const CameraFault& old) {
      if (!holdsNow(old) || old.kind != now.kind) return false;
      return old.camera == now.camera ||
             (old.kind == CameraFault::Kind::kApart && old.certain && !now.certain);
    };
    const auto old = std::find_if(faults_.begin(), faults_.end(), isThis);
    if (old == faults_.end()) {
      faults_.push_back(now);
      continue;
    }
    goes_on[static_cast<std::size_t>(old - faults_.begin())] = true;
    old->apart = std::max(old->apart, now.apart);
    if (std::abs(now.late) > std::abs(old->late)) old->late = now.late;
    old->certain = old->certain || (now.certain && old->camera == now.camera);
  }
  for (std::size_t k = 0; k < goes_on.size(); ++k)
    if (holdsNow(faults_[k]) && !goes_on[k]) faults_[k].until = t;
  std::erase_if(faults_, [&](const CameraFault& fault) { return fault.until < t - kRemembered; });
}

}  // namespace abstand::tracking
