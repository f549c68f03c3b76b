#include "tracking/tracker/camera_agreement.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "tracking/tracker/late_spans.hpp"
#include "tracking/tracker/middle_joints.hpp"
#include "tracking/tracker/refuted_spans.hpp"

namespace abstand::tracking {
namespace {

constexpr double kSamePlace = 0.5;      // m; PeopleAcross takes nearer ones for one person
constexpr double kFarthestApart = 2.0;  // m; a camera turned by 30 degrees

constexpr std::size_t kSameImages = 10;  // no two images with noise are equal

}  // namespace

CameraAgreement::CameraAgreement(std::span<const DepthCamera> cameras, const TrackedPerson::Options& options)
    : found_(cameras.size(), 0), moved_(cameras.size(), kInfinity) {
  cameras_.reserve(cameras.size());
  for (std::size_t i = 0; i < cameras.size(); ++i) cameras_.emplace_back(cameras[i], i, options);
  for (std::size_t i = 0; i < cameras.size(); ++i)
    for (std::size_t k = i + 1; k < cameras.size(); ++k) pairs_.push_back({i, k});
}

void CameraAgreement::refuseSame(const DepthMoment& moment) {
  for (Pair& pair : pairs_) {
    if (pair.differs || !moment.is_new[pair.first] || !moment.is_new[pair.second]) continue;
    pair.differs = moment.frames[pair.first]->image.z != moment.frames[pair.second]->image.z;
    pair.same += !pair.differs;
    if (pair.same == kSameImages)
      throw UsageError("found the same images in the recordings of cameras " +
                       std::to_string(pair.first + 1) + " and " + std::to_string(pair.second + 1) +
                       ", expected different cameras");
  }
}

void CameraAgreement::note(const DepthMoment& moment, const PeopleViews& views) {
  refuseSame(moment);
  for (std::size_t c = 0; c < cameras_.size(); ++c) {
    if (!moment.is_new[c]) continue;
    moved_[c] = views.movedAt(c);
    noteHang(c, moment.t, views.unchangedSince(c));
  }
}

void CameraAgreement::see(const DepthMoment& moment, PeopleViews& views) {
  for (std::size_t c = 0; c < cameras_.size(); ++c) {
    if (!moment.is_new[c]) continue;
    cameras_[c].see(moment, views);
    found_[c] += cameras_[c].findsPlaces();
  }
  for (Pair& pair : pairs_) {
    if (!moment.is_new[pair.first] || !moment.is_new[pair.second]) continue;
    compare(moment.t, pair);
    pair.through.push_back(
        throughAt(moment.t, cameras_[pair.first].labelled(), cameras_[pair.second].labelled()));
  }
}

void CameraAgreement::forgetBefore(double t) {
  const auto isBefore = [t](const auto& one) { return one.t < t; };
  for (Pair& pair : pairs_) {
    std::erase_if(pair.seen, isBefore);
    std::erase_if(pair.through, isBefore);
  }
  std::erase_if(hangs_, [t](const CameraFault& hang) { return hang.until < t; });
}

/// The images of a camera at `t` (s) have been equal since `since` (s).
void CameraAgreement::noteHang(std::size_t camera, double t, double since) {
  const auto open = std::find_if(hangs_.begin(), hangs_.end(), [&](const CameraFault& hang) {
    return hang.camera == camera && hang.until == kInfinity;
  });
  const bool hangs = t - since >= CameraShare::kHung;
  if (hangs && open == hangs_.end())
    hangs_.push_back({.kind = CameraFault::Kind::kHangs, .camera = camera, .since = since});
  else if (!hangs && open != hangs_.end())
    open->until = t;
}

/// Of several people the nearest two: wrong poses move all of them.
void CameraAgreement::compare(double t, Pair& pair) const {
  const LoneCamera &first = cameras_[pair.first], &second = cameras_[pair.second];
  double nearest = kFarthestApart;
  for (const LoneCamera::Seen& one : first.people()) {
    for (const LoneCamera::Seen& other : second.people()) {
      if (!one.hasPlace() || !other.hasPlace()) continue;
      const humanmodel::SkeletonFrame &a = one.middles, &b = other.middles;
      const std::optional<Vector3d> off = offsetBetween(a, b);
      if (!off || off->norm() >= nearest) continue;
      if (off->norm() > kSamePlace && !(first.seesThrough(b) && second.seesThrough(a))) continue;
      if (nearest == kFarthestApart) pair.seen.emplace_back();
      pair.seen.back() = {t, a, b, *off};
      nearest = off->norm();
    }
  }
}

template <class Seen>
std::vector<Seen> CameraAgreement::usable(const Pair& pair, const std::vector<Seen>& seen,
                                          std::span<const CameraFault> faults) {
  std::vector<Seen> used;
  for (const Seen& one : seen)
    if (isUsable(faults, pair.first, one.t) && isUsable(faults, pair.second, one.t)) used.push_back(one);
  return used;
}

/// The one that disagrees with more cameras at that time, or that jumped. Otherwise the one that found people
/// in fewer images; of equal ones the second.
CameraFault CameraAgreement::blamed(const Pair& pair, const ApartSpan& span,
                                    const std::vector<std::vector<ApartSpan>>& spans) const {
  std::array<int, 2> apart{};
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    const bool is_apart = std::any_of(spans[p].begin(), spans[p].end(),
                                      [&](const ApartSpan& other) { return other.holdsWith(span); });
    if (!is_apart || &pairs_[p] == &pair) continue;
    apart[0] += pairs_[p].first == pair.first || pairs_[p].second == pair.first;
    apart[1] += pairs_[p].first == pair.second || pairs_[p].second == pair.second;
  }
  CameraFault fault{.kind = CameraFault::Kind::kApart,
                    .camera = pair.second,
                    .since = span.since,
                    .until = span.until,
                    .apart = span.distance};
  if (apart[0] != apart[1]) {
    fault.camera = apart[0] > apart[1] ? pair.first : pair.second;
    fault.certain = std::min(apart[0], apart[1]) == 0;
    return fault;
  }
  if (const std::optional<int> jumped = whichJumped(pair.seen, span.since)) {
    fault.camera = *jumped == 0 ? pair.first : pair.second;
    return fault;
  }
  fault.certain = false;
  if (found_[pair.first] < found_[pair.second]) fault.camera = pair.first;
  return fault;
}

/// `spans`: of each pair.
void CameraAgreement::addApart(const std::vector<std::vector<ApartSpan>>& spans,
                               std::vector<CameraFault>& faults) const {
  for (std::size_t p = 0; p < pairs_.size(); ++p)
    for (const ApartSpan& span : spans[p]) {
      const CameraFault fault = blamed(pairs_[p], span, spans);
      const auto same = std::find_if(faults.begin(), faults.end(), [&](const CameraFault& other) {
        return other.kind == CameraFault::Kind::kApart && other.camera == fault.camera &&
               other.since < fault.until && fault.since < other.until;
      });
      if (same == faults.end()) {
        faults.push_back(fault);
        continue;
      }
      same->since = std::min(same->since, fault.since);
      same->until = std::max(same->until, fault.until);
      same->apart = std::max(same->apart, fault.apart);
      same->certain = same->certain && fault.certain;
    }
}

void CameraAgreement::addLate(std::vector<CameraFault>& faults) const {
  for (const Pair& pair : pairs_) {
    if (pair.first != 0) continue;  // whose clock is that of all
    for (const LateSpan& span : lateSpans(usable(pair, pair.seen, faults)))
      faults.push_back({.kind = CameraFault::Kind::kLate,
                        .camera = pair.second,
                        .since = span.since,
                        .until = span.until,
                        .late = span.late});
  }
}

std::vector<CameraFault> CameraAgreement::faults() const {
  std::vector<CameraFault> faults = hangs_;
  for (std::size_t c = 0; c < moved_.size(); ++c)
    if (std::isfinite(moved_[c]))
      faults.push_back({.kind = CameraFault::Kind::kMoved, .camera = c, .since = moved_[c]});
  std::vector<std::vector<ApartSpan>> spans, through;
  for (const Pair& pair : pairs_) {
    const std::vector<SeenTwice> seen = usable(pair, pair.seen, faults);
    spans.push_back(withoutRefuted(apartSpans(seen), seen, usable(pair, pair.through, faults),
                                   cameras_[pair.first].camera(), cameras_[pair.second].camera()));
  }
  addApart(spans, faults);
  addLate(faults);
  for (const Pair& pair : pairs_) {
    // People who move are elsewhere for a camera that is late.
    const bool is_late = std::any_of(faults.begin(), faults.end(), [&](const CameraFault& fault) {
      return fault.kind == CameraFault::Kind::kLate &&
             (fault.camera == pair.first || fault.camera == pair.second);
    });
    through.push_back(is_late ? std::vector<ApartSpan>{} : throughSpans(usable(pair, pair.through, faults)));
  }
  addApart(through, faults);
  return faults;
}

}  // namespace abstand::tracking
