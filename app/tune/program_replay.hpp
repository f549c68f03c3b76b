// The same recordings beside the same program at another pace.
#pragma once

#include <functional>

#include "app/tune/plan.hpp"
#include "app/tune/program_pace.hpp"
#include "app/tune/study.hpp"

namespace abstand::tune {

/// The motions of a scene's mechanisms. Throws ParseError for one that cannot be read, UsageError for a scene
/// without a motion that takes time.
std::vector<ProgramMotion> programMotions(const scene_file::SceneDescription& scene);

/// What became of some runs; the recordings have the names of their items.
struct ReplayRuns {
  std::vector<TunedRecording> recordings;
  std::vector<FailedRun> failed;
  bool interrupted{false};
};
using RunItems = std::function<ReplayRuns(const std::vector<PlanItem>&)>;

/// A run of a replay.
struct ReplayedRecording {
  TunedRecording tuned;
  double offset{0.0};  ///< s: clock of the program less time of the recording
};

/// Runs a study's recordings again, beside its program at another pace. A program that goes on when a
/// recording has ended meets it again from its beginning, in a run of its own ("round"), until its end, and
/// so does one that began before the recording: every moment of the program meets every recording. One
/// thread; not copied.
class ProgramReplay {
 public:
  /// `items`: runs with one program, that of `motions`. `recorded`: what came of them; items without a
  /// recording there are left out. `folder`: exists; motion files of the replays are written there.
  ProgramReplay(const std::vector<PlanItem>& items, const std::vector<TunedRecording>& recorded,
                std::vector<ProgramMotion> motions, std::filesystem::path folder, RunItems run);

  struct Answer {
    std::vector<ReplayedRecording> recordings;
    std::vector<FailedRun> failed;
    bool interrupted{false};
  };
  /// Throws UsageError for a program that needs more than kMaxRounds of a recording; WriteError.
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
  /// The program's motions with clocks earlier by `offset`, as files.
  std::map<std::string, std::filesystem::path> write(const ProgramPace& pace, double offset);

  std::vector<Recorded> recorded_;
  std::vector<ProgramMotion> motions_;
  std::filesystem::path folder_;
  RunItems run_;
  std::size_t files_{0};
};

}  // namespace abstand::tune
