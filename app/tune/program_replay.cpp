#include "app/tune/program_replay.hpp"

#include <algorithm>
#include <cmath>

#include "app/session/mechanism_driver.hpp"
#include "core/base/error.hpp"
#include "core/base/output_file.hpp"

namespace abstand::tune {
namespace {

// Share of a round: a program that ends with a recording up to rounding needs no further round.
constexpr double kRoundTolerance = 1e-9;

mechanism::MotionTable earlierBy(const mechanism::MotionTable& motion, double offset) {
  std::vector<double> times(motion.times().begin(), motion.times().end());
  for (double& t : times) t -= offset;
  return {std::move(times), {motion.values().begin(), motion.values().end()}, motion.dof()};
}

}  // namespace

std::vector<ProgramMotion> programMotions(const scene_file::SceneDescription& scene) {
  std::vector<ProgramMotion> motions;
  for (const auto& m : scene.mechanisms)
    if (!m.motion.empty()) motions.push_back({m.name, *session::MechanismDriver(m).motion()});
  if (motions.empty() || !(programEnd(motions) > programBegin(motions)))
    throw UsageError(scene.file.string() +
                     ": found no mechanism with a `motion` of two rows or more, expected one");
  return motions;
}

ProgramReplay::ProgramReplay(const std::vector<PlanItem>& items, const std::vector<TunedRecording>& recorded,
                             std::vector<ProgramMotion> motions, std::filesystem::path folder, RunItems run)
    : motions_(std::move(motions)), folder_(std::move(folder)), run_(std::move(run)) {
  for (const PlanItem& item : items) {
    const auto found = std::find_if(recorded.begin(), recorded.end(),
                                    [&](const TunedRecording& r) { return r.recording == item.name; });
    if (found != recorded.end()) recorded_.push_back({item, found->t0, found->seconds()});
  }
}

std::map<std::string, std::filesystem::path> ProgramReplay::write(const ProgramPace& pace, double offset) {
  std::map<std::string, std::filesystem::path> files;
  for (const ProgramMotion& m : motions_) {
    const std::filesystem::path file = folder_ / ("motion" + std::to_string(files_++) + ".csv");
    writeFile(file, mechanism::formatMotion(earlierBy(retimed(m.motion, pace), offset)));
    files[m.mechanism] = file;
  }
  return files;
}

ProgramReplay::Rounds ProgramReplay::roundsOf(const Recorded& r, const ProgramPace& pace) {
  if (!(r.duration > 0.0)) return {0, 1};
  const double first =
      std::min(0.0, std::floor((pace.clock().front() - r.t0) / r.duration + kRoundTolerance));
  const double end = std::max(1.0, std::ceil((pace.clock().back() - r.t0) / r.duration - kRoundTolerance));
  if (end - first > static_cast<double>(kMaxRounds))
    throw UsageError(r.item.name + ": found a program that takes more than " + std::to_string(kMaxRounds) +
                     " times as long as the recording, expected a shorter one");
  return {static_cast<long>(first), static_cast<long>(end)};
}

ProgramReplay::Answer ProgramReplay::run(const ProgramPace& pace) {
  std::vector<PlanItem> items;
  std::map<std::string, double> offset_of;
  std::map<double, std::map<std::string, std::filesystem::path>> written;
  for (const Recorded& r : recorded_) {
    const Rounds rounds = roundsOf(r, pace);
    for (long k = rounds.first; k < rounds.end; ++k) {
      const double offset = static_cast<double>(k) * r.duration;
      auto& files = written[offset];
      if (files.empty()) files = write(pace, offset);
      PlanItem item = r.item;
      for (const auto& [mechanism, file] : files) item.motions[mechanism] = file;
      if (k != 0) item.name += ", round " + std::to_string(k + 1);
      offset_of[item.name] = offset;
      items.push_back(std::move(item));
    }
  }
  ReplayRuns runs = run_(items);
  Answer answer;
  answer.failed = std::move(runs.failed);
  answer.interrupted = runs.interrupted;
  for (TunedRecording& tuned : runs.recordings) {
    const double offset = offset_of.at(tuned.recording);
    answer.recordings.push_back({std::move(tuned), offset});
  }
  return answer;
}

}  // namespace abstand::tune
