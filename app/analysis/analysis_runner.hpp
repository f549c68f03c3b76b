// Runs the analysis of the recording that is shown.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/analysis/analysis_feed.hpp"
#include "app/session/session.hpp"
#include "app/tune/distance_pass.hpp"
#include "core/base/retained_threads.hpp"

namespace abstand::analysis {

/// What to run: the scene, with the options of the session that is shown.
struct AnalysisRequest {
  scene_file::SceneDescription scene;
  session::SessionOptions options;
  /// As of `tune`; keep_frames and on_frame have no effect.
  tune::PassOptions pass;
  /// Names of the pairs of people's parts and robots' links that the session checks.
  std::vector<std::pair<std::string, std::string>> watched;
  std::vector<std::pair<std::string, std::string>> left_out;  ///< those of `watched` that are not analysed
};

/// The request for what `session` shows: it shares the session's structures. `options`: how its recording was
/// read. Nothing for a scene without a pair of a person and a robot.
std::optional<AnalysisRequest> requestFor(const session::Session& session,
                                          const session::SessionOptions& options = {});

/// Takes pairs, by the names of their bodies, out of those that a scene checks, also those that it names: a
/// named pair is checked whatever else is said.
void leaveOut(const std::vector<std::pair<std::string, std::string>>& pairs,
              scene_file::SceneDescription& scene);

/// Runs the recording as recorded, without reactions, as `tune` does with its usual options, and fills
/// `feed`; without a pair it fails. Ends within a few frames once that is cancelled. Throws nothing.
void runAnalysis(const AnalysisRequest& request, AnalysisFeed& feed);

/// Runs one analysis at a time, on a thread with low priority. start() and stop() wait for nobody: what was
/// under way is cancelled and ends by itself. The destructor waits. One thread.
class AnalysisRunner {
 public:
  ~AnalysisRunner();

  std::shared_ptr<AnalysisFeed> start(AnalysisRequest request);
  void stop();
  /// Threads that have not ended yet.
  std::size_t running() { return threads_.running(); }

 private:
  std::shared_ptr<AnalysisFeed> feed_;  // of the newest; null: cancelled, or there is none
  RetainedThreads threads_;
};

}  // namespace abstand::analysis
