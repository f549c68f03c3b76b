#include "tracking/acclaim/asf_skeleton.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"
#include "tracking/acclaim/words.hpp"
#include "tracking/recording/point_reader.hpp"
#include "tracking/table/cells.hpp"

namespace abstand::tracking {
namespace {

constexpr std::size_t kMaxBones = 10000;

using Words = std::vector<std::string_view>;

/// Parses the sections one by one and assembles the skeleton at the end.
class AsfParser {
 public:
  AsfParser(std::string_view text, const std::string& file) : file_(file), lines_(text) {}

  AsfSkeleton parse() {
    bones_.push_back({});
    bones_[0].name = "root";
    std::string_view line;
    while (lines_.next(line)) {
      const Words words = wordsOf(line);
      if (words.empty()) continue;
      if (words[0].front() == ':') section_ = text::lowerCase(words[0]);
      if (section_ == ":documentation" || section_ == ":skin") continue;
      if (words[0].front() != ':') readLine(words);
    }
    if (bones_.size() == 1) throw ParseError({file_, lines_.number()}, "found no bone, expected :bonedata");
    if (in_bone_) fail("found the end inside of a bone, expected 'end'");
    return inOrder();
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw ParseError({file_, lines_.number()}, message);
  }

  double number(std::string_view word) const {
    const auto v = parseDouble(word);
    if (!v || std::abs(*v) > kLargestCoordinate)
      fail("found " + text::inQuotes(word) + ", expected a number below 1e9");
    return *v;
  }

  Vector3d three(const Words& words) const {
    if (words.size() < 4) fail("found " + std::to_string(words.size() - 1) + " numbers, expected three");
    return {number(words[1]), number(words[2]), number(words[3])};
  }

  Vector3d angles(const Words& words) const {
    return out_.in_degrees ? Vector3d(three(words) * (kPi / 180.0)) : three(words);
  }

  std::string orderOf(std::string_view word) const {
    std::string order = text::lowerCase(word);
    std::string sorted = order;
    std::sort(sorted.begin(), sorted.end());
    if (sorted != "xyz") fail("found " + text::inQuotes(word) + ", expected an order like XYZ");
    return order;
  }

  void readLine(const Words& words) {
    const std::string key = text::lowerCase(words[0]);
    if (section_ == ":units") readUnit(key, words);
    if (section_ == ":root") readRoot(key, words);
    if (section_ == ":bonedata") readBone(key, words);
    if (section_ == ":hierarchy") readChildren(key, words);
  }

  void readUnit(const std::string& key, const Words& words) {
    if (words.size() < 2) fail("found " + text::inQuotes(words[0]) + " alone, expected its unit");
    if (key == "length") {
      out_.length = number(words[1]);
      if (out_.length <= 0.0)
        fail("found a unit of length " + text::inQuotes(words[1]) + ", expected more than 0");
    }
    if (key == "angle") out_.in_degrees = !text::lowerCase(words[1]).starts_with("rad");
  }

  void readRoot(const std::string& key, const Words& words) {
    AsfBone& root = bones_[0];
    if (key == "order") readChannels(words, root, true);
    if (key == "position") out_.position = three(words);
    if (key == "orientation") root_angles_ = angles(words);
    if (key == "axis") {
      if (words.size() < 2) fail("found axis alone, expected an order like XYZ");
      root.order = orderOf(words[1]);
    }
  }

  void readChannels(const Words& words, AsfBone& bone, bool is_root) const {
    bone.channels.clear();
    for (std::size_t i = 1; i < words.size(); ++i) {
      constexpr std::string_view kNames[]{"tx", "ty", "tz", "rx", "ry", "rz"};
      const auto it = std::find(std::begin(kNames), std::end(kNames), text::lowerCase(words[i]));
      const auto channel = static_cast<AsfChannel>(it - std::begin(kNames));
      if (it == std::end(kNames) || (!is_root && channel < AsfChannel::kRx))
        fail("found " + text::inQuotes(words[i]) + ", expected rx, ry or rz" +
             (is_root ? ", or tx to tz" : ""));
      if (std::find(bone.channels.begin(), bone.channels.end(), channel) != bone.channels.end())
        fail("found " + text::inQuotes(words[i]) + " a second time, expected it once");
      bone.channels.push_back(channel);
    }
  }

  void readBone(const std::string& key, const Words& words) {
    if (key == "begin") {
      if (in_bone_) fail("found begin inside of a bone, expected end first");
      if (bones_.size() == kMaxBones) fail("found more than 10000 bones, expected the skeleton of a person");
      in_bone_ = true;
      bones_.push_back({});
      length_ = 1.0;
      return;
    }
    if (!in_bone_) fail("found " + text::inQuotes(words[0]) + ", expected begin");
    AsfBone& bone = bones_.back();
    if (key == "end") {
      in_bone_ = false;
      if (bone.name.empty() || bone.name == "root") fail("found a bone without a unique name, expected one");
      bone.offset *= length_;
      if (!index_.emplace(bone.name, bones_.size() - 1).second)
        fail("found the bone " + text::inQuotes(bone.name) + " a second time, expected it once");
    } else if (key == "name") {
      if (words.size() < 2) fail("found no name, expected one");
      bone.name = words[1];
    } else if (key == "direction") {
      bone.offset = three(words);
      if (bone.offset.norm() > 0.0) bone.offset.normalize();
    } else if (key == "length") {
      if (words.size() < 2) fail("found no length, expected one");
      length_ = number(words[1]);
    } else if (key == "axis") {
      bone.order = orderOf(words.size() > 4 ? words[4] : std::string_view("XYZ"));
      bone.C = fixedAxesRotation(angles(words), bone.order);
    } else if (key == "dof") {
      readChannels(words, bone, false);
    }
  }

  void readChildren(const std::string& key, const Words& words) {
    if (key == "begin" || key == "end") return;
    const auto bone = [&](std::string_view name) {
      if (name == "root") return std::size_t{0};
      const auto it = index_.find(std::string(name));
      if (it == index_.end())
        fail("found " + text::inQuotes(name) + " in the hierarchy, expected a bone of :bonedata");
      return it->second;
    };
    const std::size_t parent = bone(words[0]);
    for (std::size_t i = 1; i < words.size(); ++i) {
      AsfBone& child = bones_[bone(words[i])];
      if (child.parent >= 0 || &child == &bones_[0])
        fail("found a second parent of " + text::inQuotes(words[i]) + ", expected one");
      child.parent = static_cast<int>(parent);
      children_.resize(bones_.size());
      children_[parent].push_back(bone(words[i]));
    }
  }

  /// Sorts parents first. Bones that are disconnected or in a cycle are not reached from the root.
  AsfSkeleton inOrder() {
    bones_[0].C = fixedAxesRotation(root_angles_, bones_[0].order);
    children_.resize(bones_.size());
    std::vector<std::pair<std::size_t, int>> open{{0, -1}};
    while (!open.empty()) {
      const auto [at, parent] = open.back();
      open.pop_back();
      const int place = static_cast<int>(out_.bones.size());
      out_.bones.push_back(bones_[at]);
      out_.bones.back().parent = parent;
      for (auto it = children_[at].rbegin(); it != children_[at].rend(); ++it) open.push_back({*it, place});
    }
    if (out_.bones.size() != bones_.size())
      fail("found " + std::to_string(bones_.size() - out_.bones.size()) +
           " bones not connected to the root, expected all of them in :hierarchy");
    return std::move(out_);
  }

  const std::string& file_;
  Lines lines_;
  std::string section_;
  AsfSkeleton out_;
  std::vector<AsfBone> bones_;
  std::vector<std::vector<std::size_t>> children_;
  std::unordered_map<std::string, std::size_t> index_;
  Vector3d root_angles_{Vector3d::Zero()};
  double length_{1.0};
  bool in_bone_{false};
};

}  // namespace

Matrix3d fixedAxesRotation(const Vector3d& angles, const std::string& order) {
  Matrix3d R = Matrix3d::Identity();
  for (const char c : order) {
    const int axis = (c | 0x20) - 'x';
    R = Eigen::AngleAxisd(angles[axis], Vector3d::Unit(axis)).toRotationMatrix() * R;
  }
  return R;
}

bool looksLikeAsf(std::string_view text) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    const Words words = wordsOf(line);
    if (words.empty()) continue;
    return words[0].front() == ':' && text.find(":bonedata") != std::string_view::npos;
  }
  return false;
}

AsfSkeleton parseAsf(std::string_view text, const std::string& file) { return AsfParser(text, file).parse(); }

}  // namespace abstand::tracking
