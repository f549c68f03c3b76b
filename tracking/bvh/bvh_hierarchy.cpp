#include "tracking/bvh/bvh_hierarchy.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_set>

#include "core/base/number.hpp"
#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr int kMaxChannels = 6;
/// s; frame times outside of these limits are errors in the file.
constexpr double kShortestFrameTime = 1e-6;
constexpr double kLongestFrameTime = 3600.0;

std::string found(std::string_view word) {
  return word.empty() ? "found the end of the file" : "found " + text::inQuotes(word);
}

double readLength(TextCursor& in, const std::string& what) {
  const auto word = in.word();
  const auto value = parseDouble(word);
  if (!value) throw ParseError(in.pos(), found(word) + ", expected a number of " + what);
  if (std::abs(*value) > kLargestBvhValue)
    throw ParseError(in.pos(), found(word) + ", expected a length below 1e9");
  return *value;
}

std::optional<BvhChannel> parseChannel(std::string_view word) {
  const std::string name = text::lowerCase(word);
  if (name.size() < 2 || name[0] < 'x' || name[0] > 'z') return std::nullopt;
  const int axis = name[0] - 'x';
  const std::string_view kind = std::string_view(name).substr(1);
  if (kind == "position") return static_cast<BvhChannel>(axis);
  if (kind == "rotation") return static_cast<BvhChannel>(3 + axis);
  return std::nullopt;
}

void readChannels(TextCursor& in, BvhJoint& joint, std::size_t& channel_count) {
  if (!joint.channels.empty())
    throw ParseError(in.pos(),
                     "found a second CHANNELS in joint " + text::inQuotes(joint.name) + ", expected one");
  const auto word = in.word();
  const auto count = parseInt(word);
  if (!count || *count < 0 || *count > kMaxChannels)
    throw ParseError(in.pos(), found(word) + ", expected the number of channels, 0 to 6");
  joint.first_channel = channel_count;
  for (int i = 0; i < *count; ++i) {
    const auto name = in.word();
    const auto channel = parseChannel(name);
    if (!channel)
      throw ParseError(in.pos(), found(name) + ", expected channel " + std::to_string(i + 1) + " of " +
                                     std::to_string(*count) + ", Xposition to Zrotation");
    if (std::find(joint.channels.begin(), joint.channels.end(), *channel) != joint.channels.end())
      throw ParseError(in.pos(), found(name) + " a second time, expected each channel once");
    joint.channels.push_back(*channel);
  }
  channel_count += joint.channels.size();
}

/// Parses one tree without recursion: untrusted nesting must not overflow the stack.
class TreeReader {
 public:
  TreeReader(TextCursor& in, BvhHierarchy& out) : in_(in), out_(out) {}

  void readRoot() {
    open(-1, false);
    while (!open_.empty()) step();
  }

 private:
  struct Level {
    std::size_t joint;
    bool is_end;
    bool has_offset{false};
  };

  void open(int parent, bool is_end) {
    const auto name = in_.restOfName();
    if (out_.joints.size() >= kMaxBvhJoints)
      throw ParseError(in_.pos(), "found more than 10000 joints, expected the skeleton of a person");
    if (open_.size() >= kDeepestBvhJoint)
      throw ParseError(in_.pos(),
                       "found joints nested more than 512 deep, expected the skeleton of a person");
    BvhJoint joint;
    joint.parent = parent;
    joint.name = is_end ? out_.joints[static_cast<std::size_t>(parent)].name + "/end" : std::string(name);
    if (joint.name.empty()) throw ParseError(in_.pos(), "found no name, expected the name of a joint");
    const auto brace = in_.word();
    if (brace != "{")
      throw ParseError(in_.pos(), found(brace) + ", expected '{' after joint " + text::inQuotes(joint.name));
    open_.push_back({out_.joints.size(), is_end});
    out_.joints.push_back(std::move(joint));
  }

  void step() {
    const auto word = in_.word();
    const std::string key = text::lowerCase(word);
    const Level level = open_.back();
    BvhJoint& joint = out_.joints[level.joint];
    if (key == "offset") {
      for (int i = 0; i < 3; ++i) joint.offset[i] = readLength(in_, "OFFSET");
      open_.back().has_offset = true;
    } else if (key == "channels" && !level.is_end) {
      readChannels(in_, joint, out_.channel_count);
    } else if (key == "joint" && !level.is_end) {
      open(static_cast<int>(level.joint), false);
    } else if (key == "end" && !level.is_end) {
      open(static_cast<int>(level.joint), true);
    } else if (key == "}") {
      if (!level.has_offset)
        throw ParseError(in_.pos(), "found the end of joint " + text::inQuotes(joint.name) +
                                        ", expected its OFFSET first");
      open_.pop_back();
    } else {
      throw ParseError(in_.pos(), found(word) + " in joint " + text::inQuotes(joint.name) +
                                      ", expected OFFSET, CHANNELS, JOINT, End Site or '}'");
    }
  }

  TextCursor& in_;
  BvhHierarchy& out_;
  std::vector<Level> open_;
};

}  // namespace

BvhHierarchy parseBvhHierarchy(TextCursor& in, std::vector<FileWarning>& warnings) {
  in.consume("\xEF\xBB\xBF");  // byte order mark of some editors
  const auto first = in.word();
  if (text::lowerCase(first) != "hierarchy")
    throw ParseError(in.pos(), found(first) + ", expected HIERARCHY");
  const auto root = in.word();
  if (text::lowerCase(root) != "root") throw ParseError(in.pos(), found(root) + ", expected ROOT");

  BvhHierarchy h;
  TreeReader(in, h).readRoot();
  const std::size_t of_first_root = h.joints.size();
  while (text::lowerCase(in.peek()) == "root") {
    in.word();
    const int line = in.line();
    const std::size_t next = h.joints.size();
    TreeReader(in, h).readRoot();
    warnings.push_back({line, "a further ROOT " + text::inQuotes(h.joints[next].name) +
                                  ": only the first skeleton is read"});
  }
  h.joints.resize(of_first_root);
  if (h.channel_count == 0)
    throw ParseError(in.pos(), "found no CHANNELS in any joint, expected at least one");

  std::unordered_set<std::string> names;
  for (const auto& joint : h.joints)
    if (!joint.name.ends_with("/end") && !names.insert(joint.name).second)
      warnings.push_back(
          {0, "the name " + text::inQuotes(joint.name) + " occurs twice: the first joint is used"});
  return h;
}

BvhMotionHead parseBvhMotionHead(TextCursor& in, std::vector<FileWarning>& warnings) {
  BvhMotionHead head;
  const auto motion = in.word();
  if (text::lowerCase(motion) != "motion") throw ParseError(in.pos(), found(motion) + ", expected MOTION");

  if (!in.consume("frames :")) throw ParseError(in.pos(), found(in.peek()) + ", expected 'Frames:'");
  const auto count = in.word();
  const auto r = std::from_chars(count.data(), count.data() + count.size(), head.frames);
  if (r.ec != std::errc{} || r.ptr != count.data() + count.size() || head.frames < 0)
    throw ParseError(in.pos(), found(count) + ", expected the number of frames");
  head.frames_line = in.line();

  if (!in.consume("frame time :")) throw ParseError(in.pos(), found(in.peek()) + ", expected 'Frame Time:'");
  const auto time = in.word();
  const auto seconds = parseDouble(time);
  if (!seconds) throw ParseError(in.pos(), found(time) + ", expected the seconds between two frames");
  if (*seconds >= kShortestFrameTime && *seconds <= kLongestFrameTime)
    head.frame_time = *seconds;
  else
    warnings.push_back(
        {in.line(), "a frame time of " + formatDouble(*seconds) + " s: 30 frames per second are assumed"});
  return head;
}

}  // namespace abstand::tracking
