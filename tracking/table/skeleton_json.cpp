#include "tracking/table/skeleton_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"
#include "tracking/table/skeleton_csv.hpp"

namespace abstand::tracking {
namespace {

using Json = nlohmann::ordered_json;

/// Limit of nesting; the parser uses memory for each level.
constexpr int kDeepest = 16;

bool isShallow(std::string_view line) {
  int depth = 0;
  for (const char c : line) {
    depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    if (depth > kDeepest) return false;
  }
  return true;
}

Json parseLine(std::string_view line, const SourcePos& pos) {
  if (!isShallow(line)) throw ParseError(pos, "found brackets nested more than 16 deep, expected a skeleton");
  Json json = Json::parse(line.begin(), line.end(), nullptr, false);
  if (!json.is_object() || !json.contains("joints") || !json["joints"].is_object())
    throw ParseError(pos, "found " + text::inQuotes(line) + ", expected an object with \"t\" and \"joints\"");
  return json;
}

double numberOf(const Json& json, const SourcePos& pos, const std::string& what) {
  if (!json.is_number() || !std::isfinite(json.get<double>()) ||
      std::abs(json.get<double>()) > kLargestCoordinate)
    throw ParseError(pos, "found no number below 1e9 for " + what + ", expected one");
  return json.get<double>();
}

double timeOf(const Json& json, const SourcePos& pos) {
  if (json.contains("t")) return numberOf(json["t"], pos, "t");
  if (!json.contains("time_us"))
    throw ParseError(pos, "found no time, expected \"t\" in seconds or \"time_us\"");
  if (!json["time_us"].is_number() || !(std::abs(json["time_us"].get<double>()) < 1e6 * kLargestCoordinate))
    throw ParseError(pos, "found no number for time_us, expected one");
  return json["time_us"].get<double>() * 1e-6;
}

humanmodel::JointState stateOf(const Json& json, const SourcePos& pos) {
  if (json.is_number()) {
    const double confidence = numberOf(json, pos, "a confidence");
    if (confidence <= 0.0) return humanmodel::JointState::kMissing;
    return confidence >= kMinTrackedConfidence ? humanmodel::JointState::kTracked
                                               : humanmodel::JointState::kInferred;
  }
  if (json == "tracked") return humanmodel::JointState::kTracked;
  if (json == "inferred") return humanmodel::JointState::kInferred;
  throw ParseError(pos,
                   "found an unknown state of a joint, expected \"tracked\", \"inferred\" or a confidence");
}

}  // namespace

bool looksLikeSkeletonJson(std::string_view text) {
  Lines lines(text);
  std::string_view line;
  while (lines.next(line))
    if (line.find_first_not_of(" \t") != std::string_view::npos)
      return line[line.find_first_not_of(" \t")] == '{' && line.find("\"joints\"") != std::string_view::npos;
  return false;
}

SkeletonJsonReader::SkeletonJsonReader(std::string_view text, std::string file)
    : file_(std::move(file)), lines_(text) {
  if (!nextLine()) throw ParseError({file_}, "the file is empty");
  const SourcePos pos{file_, lines_.number()};
  const Json json = parseLine(line_, pos);
  bool all_canonical = true;
  for (const auto& [name, value] : json["joints"].items()) {
    names_.push_back(name);
    all_canonical = all_canonical && humanmodel::parseJoint(name);
  }
  if (names_.empty()) throw ParseError(pos, "found no joint, expected them in the first line");
  facts_.format = "jsonl";
  facts_.is_canonical = all_canonical;
  if (all_canonical) {
    facts_.unit = UnitChoice{"m", "the format's own", 1.0, ""};
    facts_.up = UpChoice{"z", "the format's own", ""};
  }
  facts_.from_first_frame = !json.contains("t");
  facts_.rate_reason = json.contains("t") ? "the median step of t" : "the median step of time_us";
}

bool SkeletonJsonReader::nextLine() {
  while (!has_line_ && lines_.next(line_))
    has_line_ = line_.find_first_not_of(" \t") != std::string_view::npos;
  return has_line_;
}

bool SkeletonJsonReader::next(PointFrame& frame) {
  if (!nextLine()) return false;
  has_line_ = false;
  const SourcePos pos{file_, lines_.number()};
  const Json json = parseLine(line_, pos);
  frame.clear(names_.size());
  frame.t = timeOf(json, pos);
  if (frames_ > 0 && frame.t <= last_t_)
    throw ParseError(pos, "found t = " + formatDouble(frame.t) + " after " + formatDouble(last_t_) +
                              ", expected t to rise");
  last_t_ = frame.t;
  for (const auto& [name, value] : json["joints"].items()) {
    const auto it = std::find(names_.begin(), names_.end(), name);
    if (it == names_.end())
      throw ParseError(pos, "found the joint " + text::inQuotes(name) + ", expected one of the first line");
    if (value.is_null()) continue;
    if (!value.is_array() || (value.size() != 3 && value.size() != 4))
      throw ParseError(pos, "found no place of " + text::inQuotes(name) + ", expected [x, y, z] or null");
    Vector3d p;
    for (std::size_t k = 0; k < 3; ++k) p[static_cast<int>(k)] = numberOf(value[k], pos, name);
    const humanmodel::JointState state =
        value.size() == 4 ? stateOf(value[3], pos) : humanmodel::JointState::kTracked;
    if (state != humanmodel::JointState::kMissing)
      frame.set(static_cast<std::size_t>(it - names_.begin()), p, state);
  }
  ++frames_;
  return true;
}

}  // namespace abstand::tracking
