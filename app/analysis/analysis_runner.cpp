#include "app/analysis/analysis_runner.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>

#include "app/analysis/store_pass.hpp"
#include "app/depth/open_session.hpp"
#include "app/tune/watched_pairs.hpp"

namespace abstand::analysis {
namespace {

/// The loop and the window go first: about a tenth of their share where they want all cores.
constexpr int kNice = 10;

}  // namespace

std::optional<AnalysisRequest> requestFor(const session::Session& session,
                                          const session::SessionOptions& options) {
  if (tune::watchedPairs(session).empty()) return {};
  AnalysisRequest request;
  request.scene = session.description();
  request.options = options;
  for (const scene::Object& object : session.scene().objects())
    request.options.made[object.spec.name] = object.spec.structure;
  return request;
}

void runAnalysis(const AnalysisRequest& request, AnalysisFeed& feed) {
  try {
    session::SessionOptions options = request.options;
    options.threads = 1;
    options.monitor.cancelled = [&feed] { return feed.cancelled(); };
    // Nothing is left out, whatever the scene allows.
    options.rest = 0.0;
    options.horizon = options.budget = kInfinity;
    const auto session = depth::openSession(request.scene, options);
    if (!feed.cancelled()) storePass(*session, feed);
    feed.end({});
  } catch (const std::exception& e) {
    feed.end(e.what());
  }
}

AnalysisRunner::~AnalysisRunner() { stop(); }

std::shared_ptr<AnalysisFeed> AnalysisRunner::start(AnalysisRequest request) {
  stop();
  Job job{std::make_shared<AnalysisFeed>(), std::make_shared<std::atomic<bool>>(false), {}};
  job.thread = std::jthread([feed = job.feed, ended = job.ended, request = std::move(request)] {
    ::prctl(PR_SET_NAME, "analysis");
    ::setpriority(PRIO_PROCESS, 0, kNice);  // on Linux: of this thread alone
    runAnalysis(request, *feed);
    *ended = true;
  });
  jobs_.push_back(std::move(job));
  return jobs_.back().feed;
}

void AnalysisRunner::stop() {
  for (Job& job : jobs_) job.feed->cancel();
  running();
}

std::size_t AnalysisRunner::running() {
  std::erase_if(jobs_, [](const Job& job) { return job.ended->load(); });
  return jobs_.size();
}

}  // namespace abstand::analysis
