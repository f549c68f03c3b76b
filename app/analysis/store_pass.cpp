#include "app/analysis/store_pass.hpp"

#include <map>

#include "app/run/run_scene.hpp"
#include "app/tune/distance_pass.hpp"

namespace abstand::analysis {
namespace {

/// One pair at a settled frame.
margin::PairSample sampleOf(const tune::SettledFrame& settled, std::size_t pair) {
  const tune::WindowFrame& frame = settled.frame;
  margin::PairSample sample;
  sample.distance = frame.distance[pair];
  sample.clearance = frame.clearance[pair];
  sample.uncertainty = frame.uncertainty[pair];
  sample.between = settled.between[pair];
  sample.braking = settled.braking[pair];
  sample.closing = settled.motions[pair].closing();
  sample.lost = frame.lost[pair];
  return sample;
}

/// Hands over the poses of every n-th frame.
class PoseSampler {
 public:
  PoseSampler(const session::Session& session, AnalysisFeed& feed)
      : session_{session}, feed_{feed}, every_{1 + (session.frameTimes().size() - 1) / kMaxPoses} {}

  void frame(double t) {
    if (frame_++ % every_ != 0) return;
    view::MomentPoses poses{t, {}};
    for (const scene::Object& object : session_.scene().objects())
      poses.objects.push_back({object.X_WB, object.pose_state});
    feed_.add(std::move(poses));
  }

 private:
  const session::Session& session_;
  AnalysisFeed& feed_;
  std::size_t every_, frame_{0};
};

}  // namespace

margin::StoreLayout layoutOf(const session::Session& session, const std::vector<tune::WatchedPair>& pairs) {
  margin::StoreLayout layout;
  std::map<std::size_t, std::uint16_t> parts, links;
  const auto indexOf = [&](auto& known, std::vector<margin::StoreLayout::Body>& bodies, std::size_t object,
                           std::size_t kind) {
    const auto [at, fresh] = known.try_emplace(object, static_cast<std::uint16_t>(bodies.size()));
    if (fresh) bodies.push_back({session.scene().objects()[object].spec.name, object, kind});
    return at->second;
  };
  std::map<humanmodel::BodyPart, std::size_t> kinds;
  for (const tune::WatchedPair& pair : pairs) {
    const std::size_t kind = kinds.try_emplace(pair.body_part, kinds.size()).first->second;
    const std::uint16_t part = indexOf(parts, layout.parts, pair.part, kind);
    layout.pairs.push_back({part, indexOf(links, layout.links, pair.link, 0)});
  }
  return layout;
}

void storePass(session::Session& session, AnalysisFeed& feed, tune::PassOptions options) {
  options.keep_frames = false;
  std::unique_ptr<margin::ChunkWriter> writer;
  std::vector<margin::PairSample> samples;
  const auto hand = [&feed](std::shared_ptr<const margin::ClearanceChunk> chunk) {
    if (chunk && !feed.cancelled()) feed.add(std::move(chunk));
  };
  options.on_frame = [&](const tune::SettledFrame& settled, const tune::PassResult&) {
    samples.clear();
    for (std::size_t p = 0; p < settled.between.size(); ++p) samples.push_back(sampleOf(settled, p));
    hand(writer->add(settled.frame.t, samples));
  };
  tune::DistancePass pass(session, options);
  const auto layout = std::make_shared<const margin::StoreLayout>(layoutOf(session, pass.watched()));
  writer = std::make_unique<margin::ChunkWriter>(layout, options.limit);
  feed.begin(layout);
  tune::pauseOthers(pass.watched(), session);
  run::RunOptions run;
  run.interrupted = [&feed] { return feed.cancelled(); };
  run.progress = [&feed](std::size_t done, std::size_t all) { feed.tell(done, all); };
  PoseSampler poses(session, feed);
  run.on_cycle = [&](double t, const std::vector<query::PairResult>& results) {
    poses.frame(t);
    pass.frame(t, results);
  };
  run::runScene(session, run);
  if (feed.cancelled()) return;
  pass.finish();
  hand(writer->finish());
}

}  // namespace abstand::analysis
