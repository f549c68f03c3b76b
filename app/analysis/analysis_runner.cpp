#include "app/analysis/analysis_runner.hpp"

#include <algorithm>

#include "app/analysis/store_pass.hpp"
#include "app/depth/open_session.hpp"
#include "app/tune/watched_pairs.hpp"
#include "core/base/background_thread.hpp"

namespace abstand::analysis {

void leaveOut(const std::vector<std::pair<std::string, std::string>>& pairs,
              scene_file::SceneDescription& scene) {
  scene_file::PairsDescription& rules = scene.pairs;
  for (const auto& [a, b] : pairs) {
    for (std::size_t i = rules.include.size(); i-- > 0;) {
      const auto& [x, y] = rules.include[i];
      if (!((x == a && y == b) || (x == b && y == a))) continue;
      rules.include.erase(rules.include.begin() + static_cast<std::ptrdiff_t>(i));
      if (i < rules.include_pos.size())
        rules.include_pos.erase(rules.include_pos.begin() + static_cast<std::ptrdiff_t>(i));
    }
    rules.exclude.insert(rules.exclude.begin(), {a, b});
    if (!rules.exclude_pos.empty()) rules.exclude_pos.insert(rules.exclude_pos.begin(), SourcePos{});
  }
}

std::optional<AnalysisRequest> requestFor(const session::Session& session,
                                          const session::SessionOptions& options) {
  const std::vector<tune::WatchedPair> watched = tune::watchedPairs(session);
  if (watched.empty()) return {};
  AnalysisRequest request;
  const auto name = [&](std::size_t object) { return session.scene().objects()[object].spec.name; };
  for (const tune::WatchedPair& pair : watched)
    request.watched.emplace_back(name(pair.part), name(pair.link));
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
    scene_file::SceneDescription scene = request.scene;
    leaveOut(request.left_out, scene);
    const auto session = depth::openSession(std::move(scene), options);
    if (!feed.cancelled()) storePass(*session, feed, request.pass);
    feed.end({});
  } catch (const std::exception& e) {
    feed.end(e.what());
  }
}

AnalysisRunner::~AnalysisRunner() { stop(); }

std::shared_ptr<AnalysisFeed> AnalysisRunner::start(AnalysisRequest request) {
  stop();
  feed_ = std::make_shared<AnalysisFeed>();
  threads_.start([feed = feed_, request = std::move(request)] {
    beBackgroundThread("analysis");
    runAnalysis(request, *feed);
  });
  return feed_;
}

void AnalysisRunner::stop() {
  if (feed_) feed_->cancel();
  feed_.reset();
}

}  // namespace abstand::analysis
