#include "tracking/tracker/compared_clocks.hpp"

#include "tracking/tracker/lone_camera.hpp"
#include "tracking/tracker/processor_seconds.hpp"
#include "tracking/tracker/turned_round.hpp"

namespace abstand::tracking {
namespace {

using Frames = std::vector<humanmodel::SkeletonFrame>;

/// The joints of each person in the first images, until the camera is moved.
std::vector<Frames> peopleIn(DepthStream& stream, const ClipTrackerOptions& options, double& seconds) {
  std::map<int, Frames> people;
  const DepthCamera camera = stream.camera();
  PeopleViews views({&camera, 1});
  LoneCamera alone(camera, 0, options.person);
  const double until = stream.times().empty() ? 0.0 : stream.times().front() + kCompared;
  stream.seek(0);
  DepthFrame frame;
  while (!(options.interrupted && options.interrupted()) && stream.next(frame) && frame.t < until) {
    const double begin = processorSeconds();
    const DepthMoment moment{frame.t, {&frame}, {true}};
    views.see(moment, options.known);
    alone.see(moment, views);
    for (const LoneCamera::Seen& person : alone.people()) people[person.id].push_back(person.joints);
    seconds += processorSeconds() - begin;
  }
  std::vector<Frames> all;
  for (auto& [id, frames] : people) {
    std::erase_if(frames, [&](const humanmodel::SkeletonFrame& one) { return one.t >= views.movedAt(0); });
    if (!frames.empty()) all.push_back(std::move(frames));
  }
  return all;
}

Frames facingOtherWay(const Frames& frames) {
  Frames other;
  other.reserve(frames.size());
  for (const humanmodel::SkeletonFrame& frame : frames) other.push_back(flippedFacing(frame));
  return other;
}

bool isBetter(const ClockOffset& one, const ClockOffset& than) {
  if (one.overlap == 0.0) return false;
  return one.decided != than.decided ? one.decided : one.apart < than.apart;
}

ClockOffset bestOf(const std::vector<Frames>& first, const std::vector<Frames>& second) {
  ClockOffset best;
  best.apart = kInfinity;
  for (const Frames& b : second) {
    const Frames turned = facingOtherWay(b);
    for (const Frames& a : first)
      for (const Frames* either : {&b, &turned})
        if (const ClockOffset offset = estimateClockOffset(a, *either); isBetter(offset, best)) best = offset;
  }
  return best;
}

}  // namespace

ComparedClocks compareClocks(std::span<DepthStream* const> streams, const ClipTrackerOptions& options) {
  ComparedClocks clocks;
  std::vector<Frames> first;
  for (DepthStream* stream : streams) {
    std::vector<Frames> people = peopleIn(*stream, options, clocks.seconds);
    if (stream == streams.front()) {
      first = std::move(people);
      continue;
    }
    const double begin = processorSeconds();
    clocks.offsets.push_back(bestOf(first, people));
    clocks.seconds += processorSeconds() - begin;
  }
  return clocks;
}

}  // namespace abstand::tracking
