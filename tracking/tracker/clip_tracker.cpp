// Passes over a stream: people in each image, and the body of each.
#include "tracking/tracker/clip_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "humanmodel/joint_covariance.hpp"
#include "tracking/tracker/camera_agreement.hpp"
#include "tracking/tracker/camera_stand.hpp"
#include "tracking/tracker/compare_pace.hpp"
#include "tracking/tracker/doubtful_cameras.hpp"
#include "tracking/tracker/learned_people.hpp"
#include "tracking/tracker/processor_seconds.hpp"
#include "tracking/tracker/start_trial.hpp"

namespace abstand::tracking {
namespace {

constexpr std::array<humanmodel::Joint, 2> kHands{humanmodel::Joint::kHandLeft,
                                                  humanmodel::Joint::kHandRight};

class ClipPasses {
 public:
  ClipPasses(std::span<const ClipCamera> streams, const ClipTrackerOptions& options)
      : streams_{streams}, options_{options}, moments_{streams} {}

  ClipTrack run() {
    for (const ClipCamera& camera : streams_) cameras_.push_back(camera.stream->camera());
    estimateCameraPose();
    track_.camera = cameras_.front();
    for (const DepthCamera& camera : cameras_)
      track_.camera.spread = std::max(track_.camera.spread, camera.spread);
    learnPeople();
    trackPeople();
    if (!times_.empty()) track_.begin = times_.front();
    widenByFaults(faults_, track_);
    finishTrack(track_);
    return std::move(track_);
  }

 private:
  void estimateCameraPose() {
    DepthStream& stream = *streams_.front().stream;
    if (stream.facts().pose_known) {
      track_.world = cameras_.size() == 1 ? "the camera pose is taken from its file"
                                          : "the camera poses are taken from their files";
      return;
    }
    stream.seek(0);
    DepthFrame frame;
    CameraStand camera_pose(cameras_.front(), options_.person.height);
    while (!isInterrupted() && stream.next(frame) && !camera_pose.see(frame.t, frame.image)) {
    }
    camera_pose.settle();
    cameras_.front().X_WC = camera_pose.X_WC();
    track_.world = camera_pose.reason();
  }

  bool isInterrupted() {
    track_.interrupted = track_.interrupted || (options_.interrupted && options_.interrupted());
    return track_.interrupted;
  }

  void leaveOutFaulty(double t, PeopleViews& views) const {
    for (std::size_t c = 0; c < cameras_.size(); ++c) views.leaveOut(c, !isUsable(faults_, c, t));
  }

  /// After moment `i` of a pass.
  void noteProgress(std::size_t pass, std::size_t i) const {
    if (options_.progress) options_.progress(pass * moments_.size() + i + 1, passes_ * moments_.size());
  }

  /// First pass: the bodies of the people, where they arrive, and things. Of several cameras also whether
  /// they disagree, compared as often as live ones. If so, another pass compares all images, and if some of
  /// them cannot be used, a last one without these learns the rest.
  void learnPeople() {
    const bool compares = cameras_.size() > 1;
    learnPeopleWith(compares ? Compared::kEverySecond : Compared::kNone);
    if (faults_.empty()) return;
    learnAgainWith(Compared::kAll);
    if (std::any_of(faults_.begin(), faults_.end(), std::mem_fn(&CameraFault::leavesOut)))
      learnAgainWith(Compared::kNone);
  }

  /// Moments in which cameras are compared.
  enum class Compared : std::uint8_t { kNone, kEverySecond, kAll };

  void learnAgainWith(Compared compared) {
    learned_ = LearnedPeople(options_.person);
    if (compared != Compared::kNone) faults_.clear();
    ++passes_;
    learnPeopleWith(compared);
  }

  /// Sets faults_ if it compares; they are respected otherwise.
  void learnPeopleWith(Compared compared) {
    std::optional<CameraAgreement> agreement;
    if (compared != Compared::kNone) agreement.emplace(cameras_, options_.person);
    ComparePace pace(cameras_.size());
    moments_.rewind();
    PeopleViews views(cameras_);
    DepthMoment moment;
    for (std::size_t i = 0; moments_.next(moment) && moment.t < options_.until && !isInterrupted(); ++i) {
      const double begin = processorSeconds();
      leaveOutFaulty(moment.t, views);
      views.see(moment, options_.known);
      if (agreement) agreement->note(moment, views);
      if (agreement && (compared == Compared::kAll || pace.isDue(moment.t, moment.is_new))) {
        pace.note(moment.t, moment.is_new);
        agreement->see(moment, views);
      }
      learned_.see(moment.t, views);
      track_.seconds += processorSeconds() - begin;
      noteProgress(passes_ - 2, i);
    }
    const double begin = processorSeconds();
    learned_.settle(views);
    if (agreement) faults_ = agreement->faults();
    track_.seconds += processorSeconds() - begin;
    seen_ = views.seen();
  }

  /// A person whom the first pass has learned, at moment `number`, before the first body is chosen.
  void start(std::size_t number, const DepthMoment& moment, int person, const LearnedPeople::Learned& learned,
             std::span<const PersonImage> images, const PeopleViews& views) {
    kept_.keep(number, moment, person, images, views);
    if (moment.t < learned.start) return;
    StartTrial& trial =
        starts_.try_emplace(person, options_.person, learned.body, moment.t, learned.cost).first->second;
    if (moment.t < std::min(trial.end(), learned.last)) return;
    trial.add(kept_.take(person, views));
    StartTrial::Result best = trial.run();
    if (best.contradicts_first && moment.t < learned.last && trial.extend()) return;
    const TrackedPerson& tracker = trackers_.try_emplace(person, std::move(*best.tracker)).first->second;
    std::size_t next = 0;
    for (std::size_t i = 0; i < trial.moments().size(); ++i) {
      const KeptMoment& then = trial.moments()[i];
      if (next == 0 && !best.bodies[i].found) continue;
      for (; next > 0 && next < then.number; ++next)
        noteMoment(track_, place_, person, times_[next], nullptr, true);
      const KeptMoment::Image& image = then.images.front();
      record({then.number, person, *image.frame, *image.camera, tracker.rig(), best.bodies[i]}, then.lag,
             tracker);
      next = then.number + 1;
    }
    starts_.erase(person);
  }

  /// A camera was moved: its images are not used for the first bodies.
  void loseStarts() {
    starts_.clear();
    kept_ = {};
  }

  /// Second pass: the bodies in all moments.
  void trackPeople() {
    moments_.rewind();
    PeopleViews views(cameras_);
    views.expect(seen_);
    DepthMoment moment;
    for (std::size_t i = 0; moments_.next(moment) && moment.t < options_.until && !isInterrupted(); ++i) {
      const double begin = processorSeconds();
      times_.push_back(moment.t);
      leaveOutFaulty(moment.t, views);
      views.see(moment, options_.known);
      if (const double moved_at = views.note(track_.cameras); moved_at < kInfinity) {
        loseSince(track_, moved_at);
        loseStarts();
      }
      kept_.keepForeseen(i, moment, views);
      views.each([&](int person, std::size_t first, std::span<const PersonImage> images) {
        const LearnedPeople::Learned* learned = learned_.find(first, views.idOf(person, first));
        if (learned && trackers_.count(person) == 0) return start(i, moment, person, *learned, images, views);
        TrackedPerson& tracker = trackers_.try_emplace(person, options_.person).first->second;
        const TrackedBody* body = tracker.see(moment.t, images);
        if (!body) return noteMoment(track_, place_, person, moment.t, nullptr, true);
        record({i, person, *moment.frames[first], cameras_[first], tracker.rig(), *body},
               images.size() > 1 ? moment.lag : 0.0, tracker);
      });
      noteAbsent(moment.t);
      track_.seconds += processorSeconds() - begin;
      ++track_.images;
      noteProgress(passes_ - 1, i);
    }
    for (const auto& [id, k] : place_) {
      const TrackedPerson& tracker = trackers_.at(id);
      if (!tracker.hasBody()) continue;
      track_.people[k].body = tracker.body();
      track_.people[k].facing = tracker.facing();
      track_.people[k].stature = tracker.stature();
    }
  }

  /// Into track_, and to whom it may concern. `lag` (s): of images that were fitted
  /// together.
  void record(const ClipMoment& moment, double lag, const TrackedPerson& tracker) {
    noteMoment(track_, place_, moment.id, moment.body.frame.t, &moment.body, true);
    ClipPerson& person = track_.people[place_[moment.id]];
    if (moment.body.found) {
      const HeldThings::Extents& extent = tracker.held().extent();
      noteHeld(person, extent);
      widenEarlier(moment, extent, person.frames);
    }
    track_.lag = std::max(track_.lag, lag);
    if (person.frames.size() > 1)
      widenByLag(lag, person.frames[person.frames.size() - 2], person.frames.back());
    if (!options_.watch) return;
    const double pause = processorSeconds();
    options_.watch(moment);
    track_.seconds -= processorSeconds() - pause;
  }

  /// A thing is noticed after some images in which it was in the hand already; the images in which a body was
  /// chosen are recorded when all of them are known.
  void widenEarlier(const ClipMoment& moment, const HeldThings::Extents& extent,
                    std::vector<humanmodel::SkeletonFrame>& frames) {
    HeldThings::Extents& before = held_[moment.id];
    for (std::size_t k = 0; k < extent.size(); ++k) {
      const double more = extent[k] - moment.body.held[k];
      if (more > 0.0) humanmodel::addRadius(frames.back(), kHands[k], more);
      const bool is_new = before[k] == 0.0 && extent[k] > 0.0;
      const std::size_t earlier = is_new ? std::min<std::size_t>(frames.size() - 1, HeldThings::kWindow) : 0;
      for (std::size_t i = frames.size() - 1 - earlier; i + 1 < frames.size(); ++i)
        if (frames[i].has(kHands[k])) humanmodel::addRadius(frames[i], kHands[k], extent[k]);
    }
    before = extent;
  }

  /// People not in these images are lost.
  void noteAbsent(double t) {
    humanmodel::SkeletonFrame none;
    none.t = t;
    for (const auto& [id, k] : place_)
      if (track_.people[k].frames.back().t < t) track_.people[k].frames.push_back(none);
  }

  std::map<int, HeldThings::Extents> held_;  ///< in the last image, by person
  std::span<const ClipCamera> streams_;
  const ClipTrackerOptions& options_;
  DepthMoments moments_;
  std::vector<DepthCamera> cameras_;
  LearnedPeople learned_{options_.person};
  std::size_t passes_{2};
  std::vector<CameraFault> faults_;
  std::vector<SeenBefore> seen_;  // in the first pass, for each camera
  std::map<int, TrackedPerson> trackers_;
  std::map<int, StartTrial> starts_;  // of people who are not tracked yet
  std::vector<double> times_;         // s, of all moments so far
  KeptImages kept_;
  ClipTrack track_;
  std::map<int, std::size_t> place_;  // index in track_.people of each person
};

}  // namespace

void noteMoment(ClipTrack& track, std::map<int, std::size_t>& place, int id, double t,
                const TrackedBody* body, bool keep) {
  const auto [it, is_new] = place.try_emplace(id, track.people.size());
  if (is_new) {
    track.people.emplace_back();
    track.people.back().id = id;
    track.people.back().residual = 0.0;
  }
  ClipPerson& person = track.people[it->second];
  if (keep) {
    humanmodel::SkeletonFrame none;
    none.t = t;
    person.frames.push_back(body ? body->frame : none);
    for (std::size_t j = 0; j < humanmodel::kJointCount; ++j)
      humanmodel::addSpread(person.frames.back(), static_cast<humanmodel::Joint>(j), track.camera.spread);
  }
  if (!body || !body->found) return;
  ++person.found;
  person.residual += body->misfit.residual;
}

void loseSince(ClipTrack& track, double t) {
  if (t == kInfinity) return;
  for (ClipPerson& person : track.people)
    for (humanmodel::SkeletonFrame& frame : person.frames) {
      if (frame.t < t) continue;
      person.found -= frame.has(humanmodel::Joint::kPelvis) ? 1 : 0;
      humanmodel::SkeletonFrame none;
      none.t = frame.t;
      frame = none;
    }
}

void widenByLag(double lag, const humanmodel::SkeletonFrame& before, humanmodel::SkeletonFrame& frame) {
  if (lag <= 0.0) return;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto joint = static_cast<humanmodel::Joint>(j);
    if (!frame.has(joint) || !before.has(joint)) continue;
    const double moved = (frame.p[j] - before.p[j]).norm() * lag / (frame.t - before.t);
    humanmodel::addSpread(frame, joint, moved);
  }
}

void noteHeld(ClipPerson& person, const HeldThings::Extents& extent) {
  for (std::size_t k = 0; k < extent.size(); ++k) {
    person.held[k] += extent[k] > 0.0;
    person.held_extent[k] = std::max(person.held_extent[k], extent[k]);
  }
}

void finishTrack(ClipTrack& track) {
  for (ClipPerson& person : track.people)
    person.residual /= std::max<double>(1.0, static_cast<double>(person.found));
  std::stable_sort(track.people.begin(), track.people.end(),
                   [](const ClipPerson& a, const ClipPerson& b) { return a.found > b.found; });
}

ClipTrack trackClip(DepthStream& stream, const ClipTrackerOptions& options) {
  const ClipCamera camera{&stream, 0.0};
  return ClipPasses({&camera, 1}, options).run();
}

ClipTrack trackClips(std::span<const ClipCamera> cameras, const ClipTrackerOptions& options) {
  requireCameras(cameras.size(), std::all_of(cameras.begin(), cameras.end(), [](const ClipCamera& camera) {
                   return camera.stream->facts().pose_known;
                 }));
  return ClipPasses(cameras, options).run();
}

}  // namespace abstand::tracking
