#include "app/results/mcap_results.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "app/results/mcap_messages.hpp"
#include "app/results/mcap_writer.hpp"
#include "app/tune/part_frames.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/base/utf8.hpp"

namespace abstand::results {
namespace {

// ns: below 2^63, so that readers with signed integers work.
constexpr double kMaxNanoseconds = 9.2e18;

/// Converts to valid UTF-8, as MCAP requires; file names may be in any encoding.
std::string plainText(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = characterLength(std::string_view(text).substr(i));
    plain += length > 0 ? text.substr(i, length) : "?";
    i += std::max<std::size_t>(1, length);
  }
  return plain;
}

/// Length of the common folders of all names.
std::size_t sharedFolders(const std::vector<std::string>& names) {
  std::size_t shared = names.front().size();
  for (const std::string& name : names) {
    const auto [a, b] = std::mismatch(names.front().begin(), names.front().end(), name.begin(), name.end());
    shared = std::min(shared, static_cast<std::size_t>(a - names.front().begin()));
  }
  const auto slash = names.front().rfind('/', shared == 0 ? 0 : shared - 1);
  return slash == std::string::npos || slash >= shared ? 0 : slash + 1;
}

/// Time and reference of a message.
struct Moment {
  enum class Kind : std::uint8_t { kFrame, kApproach, kEvent };
  std::uint64_t log_time;  ///< ns
  Kind kind;
  std::size_t recording, index;  ///< index of the recording; of the frame, approach or event
  auto order() const { return std::tie(log_time, kind, recording, index); }
};

class ResultsMcap {
 public:
  ResultsMcap(const tune::TuneAnswer& answer, const McapOptions& options, const std::filesystem::path& file)
      : answer_(answer), options_(options), file_(file), out_(file, options.library) {
    // MCAP times are not negative.
    for (const tune::TunedRecording& r : answer.recordings) origin_ = std::min(origin_, std::floor(r.t0));
    approaches_ = tune::rankedApproaches(answer);
    // The messages of all recordings are in order of time.
    for (const tune::TunedRecording& r : answer.recordings) frames_.emplace_back(r);
    if (!options.margin) return;
    for (const tune::TunedRecording& r : answer.recordings) {
      const auto some = tune::marginEvents(r, *options.margin, answer.options.margins());
      events_.insert(events_.end(), some.begin(), some.end());
    }
  }

  McapCounts write() {
    addChannels();
    addOptions();
    McapCounts counts{channels_, 0};
    for (const Moment& m : moments()) {
      counts.messages += m.kind == Moment::Kind::kFrame ? writeFrame(m) : 1;
      if (m.kind == Moment::Kind::kApproach)
        out_.add(approach_channel_, m.log_time, approachMessage(approaches_[m.index]));
      if (m.kind == Moment::Kind::kEvent)
        out_.add(event_channel_, m.log_time, eventMessage(events_[m.index]));
    }
    out_.commit();
    return counts;
  }

 private:
  std::uint16_t channel(std::uint16_t schema, const std::string& topic, const TextMap& metadata) {
    ++channels_;
    return out_.addChannel(schema, topic, metadata);
  }
  void addChannels() {
    const std::uint16_t clearance = out_.addSchema("abstand.Clearance", kClearanceSchema);
    std::vector<std::string> names;
    for (const tune::TunedRecording& r : answer_.recordings) names.push_back(r.recording);
    const std::vector<std::string> topics = topicNames(names);
    for (std::size_t i = 0; i < names.size(); ++i) {
      part_channels_.emplace_back();
      for (const tune::PartClearance& p : answer_.recordings[i].pass.parts)
        part_channels_.back().push_back(channel(clearance, topics[i] + "/" + p.part,
                                                {{"recording", plainText(names[i])}, {"part", p.part}}));
    }
    approach_channel_ = channel(out_.addSchema("abstand.Approach", kApproachSchema), "/approaches", {});
    if (!options_.margin) return;
    event_channel_ = channel(out_.addSchema("abstand.Event", kEventSchema), "/events",
                             {{"margin", formatDouble(*options_.margin)}});
  }
  void addOptions() {
    const tune::PassOptions& pass = answer_.options.pass;
    TextMap options{{"time_origin", formatDouble(origin_)},
                    {"limit", formatDouble(pass.limit)},
                    {"reaction_time", formatDouble(pass.braking.reaction_time)},
                    {"deceleration", formatDouble(pass.braking.deceleration)},
                    {"units", "m, s, m/s, kg, N, Pa"}};
    if (options_.margin) options["margin"] = formatDouble(*options_.margin);
    out_.addMetadata("abstand", options);
  }
  std::uint64_t nanoseconds(double t) const {
    const double ns = std::round((t - origin_) * 1e9);
    if (!(ns >= 0.0 && ns < kMaxNanoseconds))
      throw UsageError(file_.string() + ": found a time of " + formatDouble(t) +
                       " s, expected times that fit 64 bits of nanoseconds");
    return static_cast<std::uint64_t>(ns);
  }
  std::vector<Moment> moments() const {
    std::vector<Moment> all;
    for (std::size_t r = 0; r < answer_.recordings.size(); ++r) {
      const std::vector<double>& t = frames_[r].times();
      for (std::size_t i = 0; i < t.size(); ++i)
        all.push_back({nanoseconds(t[i]), Moment::Kind::kFrame, r, i});
    }
    for (std::size_t i = 0; i < approaches_.size(); ++i)
      all.push_back({nanoseconds(approaches_[i].approach->t), Moment::Kind::kApproach, 0, i});
    for (std::size_t i = 0; i < events_.size(); ++i)
      all.push_back({nanoseconds(events_[i].t0), Moment::Kind::kEvent, 0, i});
    std::sort(all.begin(), all.end(), [](const Moment& a, const Moment& b) { return a.order() < b.order(); });
    return all;
  }
  std::size_t writeFrame(const Moment& m) {
    const std::vector<std::uint16_t>& channels = part_channels_[m.recording];
    for (std::size_t p = 0; p < channels.size(); ++p)
      out_.add(channels[p], m.log_time,
               clearanceMessage(answer_.recordings[m.recording], frames_[m.recording].parts()[p], m.index));
    return channels.size();
  }

  const tune::TuneAnswer& answer_;
  const McapOptions& options_;
  const std::filesystem::path& file_;
  McapWriter out_;
  double origin_{0.0};                    ///< s: time 0 of the file
  std::vector<tune::PartFrames> frames_;  ///< of each recording
  std::vector<tune::RankedApproach> approaches_;
  std::vector<tune::MarginEvent> events_;
  std::vector<std::vector<std::uint16_t>> part_channels_;  ///< for each recording and part
  std::uint16_t approach_channel_{0}, event_channel_{0};
  std::size_t channels_{0};
};

}  // namespace

std::vector<std::string> topicNames(const std::vector<std::string>& recordings) {
  std::vector<std::string> topics;
  std::set<std::string> taken;
  if (recordings.empty()) return topics;
  const std::size_t shared = sharedFolders(recordings);
  for (const std::string& name : recordings) {
    std::string topic = "/";
    for (const char c : name.substr(shared)) {
      const bool kept =
          (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '/';
      const char next = kept ? c : '_';
      // Repeated separators are merged, and a folder has a name.
      if ((next == '_' || next == '/') && topic.back() == next) continue;
      topic += next;
    }
    while (topic.size() > 1 && (topic.back() == '_' || topic.back() == '/')) topic.pop_back();
    if (topic == "/") topic = "/recording";
    std::string unique = topic;
    for (int n = 2; !taken.insert(unique).second; ++n) unique = topic + "_" + std::to_string(n);
    topics.push_back(std::move(unique));
  }
  return topics;
}

McapCounts writeMcap(const tune::TuneAnswer& answer, const McapOptions& options,
                     const std::filesystem::path& file) {
  return ResultsMcap(answer, options, file).write();
}

}  // namespace abstand::results
