// The distance pass of a recording into chunks.
#pragma once

#include "app/analysis/analysis_feed.hpp"
#include "app/tune/distance_pass.hpp"
#include "app/tune/watched_pairs.hpp"

namespace abstand::analysis {

/// Parts and links in the order in which the pairs name them first.
margin::StoreLayout layoutOf(const session::Session& session, const std::vector<tune::WatchedPair>& pairs);

/// The poses of at most about so many moments are kept for small pictures.
inline constexpr std::size_t kMaxPoses = 600;

/// `options`: as AnalysisRequest::pass. Runs all frames until the end or until the feed is cancelled. Throws
/// UsageError for a scene without a pair of a person and a robot.
void storePass(session::Session& session, AnalysisFeed& feed, tune::PassOptions options = {});

}  // namespace abstand::analysis
