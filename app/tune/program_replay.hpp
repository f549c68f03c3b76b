// Replays recordings with the same robot program at another pace.
#pragma once

#include <functional>

#include "app/tune/plan.hpp"
#include "app/tune/program_pace.hpp"
#include "app/tune/study.hpp"

namespace abstand::tune {

/// Motions of a scene's mechanisms. Throws ParseError for an unreadable one, UsageError for a scene without a
/// motion of positive duration.
std::vector<ProgramMotion> programMotions(const scene_file::SceneDescription& scene);

/// Results of some runs; the recordings have the names of their items.
struct ReplayRuns {
  std::vector<TunedRecording> recordings;
  std::vector<FailedRun> failed;
  bool interrupted{false};
};
using RunItems = std::function<ReplayRuns(const std::vector<PlanItem>&)>;

/// A run of a replay.
struct ReplayedRecording {
  TunedRecording tuned;
  double offset{0.0};  ///< s: program clock minus recording time
};

/// Reruns a study's recordings with its program at another pace. If the program is longer than a recording,
/// the recording is repeated in further runs ("rounds") until the program ends, and likewise if the program
/// started before the recording: every time of the program meets every recording. One thread; not copied.
class ProgramReplay {
 public:
  /// `items`: runs with one program, that of `motions`. `recorded`: their results; items without a result are
  /// skipped. `folder`: exists; motion files of the replays are written there.
  ProgramReplay(const std::vector<PlanItem>& items, const std::vector<TunedRecording>& recorded,
                std::vector<ProgramMotion> motions, std::filesystem::path folder, RunItems run);

  struct Answer {
    std::vector<ReplayedRecording> recordings;
    std::vector<FailedRun> failed;
    bool interrupted{false};
  };
  /// Throws UsageError if a recording needs more than kMaxRounds; WriteError.
  Answer run(const ProgramPace& pace);
  const std::vector<ProgramMotion>& motions() const { return motions_; }

  static constexpr std::size_t kMaxRounds = 1000;

 private:
  struct Recorded {
    PlanItem item;
    double t0{0.0}, duration{0.0};  ///< s
  };
  struct Rounds {
    long first{0}, end{1};  ///< 0: in step with the recording
  };
  static Rounds roundsOf(const Recorded& recorded, const ProgramPace& pace);
  /// Writes the program's motions with clocks shifted back by `offset` to files.
  std::map<std::string, std::filesystem::path> write(const ProgramPace& pace, double offset);

  std::vector<Recorded> recorded_;
  std::vector<ProgramMotion> motions_;
  std::filesystem::path folder_;
  RunItems run_;
  std::size_t files_{0};
};

}  // namespace abstand::tune
