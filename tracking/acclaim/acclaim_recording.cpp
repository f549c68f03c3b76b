#include "tracking/acclaim/acclaim_recording.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/text/message_text.hpp"

namespace abstand::tracking {
namespace {

constexpr double kCmuRate = 120.0;
constexpr double kCmuLength = 0.45;

}  // namespace

std::filesystem::path findAsf(const std::filesystem::path& amc, const std::filesystem::path& wanted) {
  namespace fs = std::filesystem;
  if (!wanted.empty()) return wanted;
  const std::string own = amc.stem().string();
  std::vector<fs::path> all;
  std::error_code ec;
  for (fs::directory_iterator it(amc.has_parent_path() ? amc.parent_path() : fs::path("."), ec), end;
       !ec && it != end; it.increment(ec))
    if (text::lowerCase(it->path().extension().string()) == ".asf") all.push_back(it->path());
  std::sort(all.begin(), all.end());
  const fs::path* best = nullptr;
  for (const auto& path : all)
    if (own.starts_with(path.stem().string()) &&
        (!best || path.stem().string().size() > best->stem().string().size()))
      best = &path;
  if (best) return *best;
  if (all.size() == 1) return all.front();
  throw ParseError(
      {amc.string()},
      "found " + (all.empty() ? std::string("no ASF file") : std::to_string(all.size()) + " ASF files") +
          " next to this AMC and none with a matching name, expected its skeleton",
      "name it with --skeleton FILE.asf");
}

AcclaimPoints::AcclaimPoints(std::string_view asf, std::string asf_file, std::string_view amc,
                             std::string amc_file)
    : skeleton_(parseAsf(asf, asf_file)) {
  facts_.format = amc.empty() ? "asf" : "amc";
  facts_.rate = kCmuRate;
  facts_.rate_reason =
      amc.empty() ? "a skeleton without motion" : "no rate in the file: 120 Hz are assumed, as CMU recorded";
  if (std::abs(skeleton_.length - kCmuLength) < 1e-9)
    facts_.unit = UnitChoice{"cmu", "the ASF states length 0.45, CMU's 1 / 0.45 inch per unit",
                             0.0254 / kCmuLength, ""};

  std::vector<bool> has_child(skeleton_.bones.size(), false);
  for (const AsfBone& bone : skeleton_.bones) {
    names_.push_back(bone.name);
    channels_ += bone.channels.size();
    if (bone.parent >= 0) has_child[static_cast<std::size_t>(bone.parent)] = true;
  }
  for (std::size_t i = 0; i < has_child.size(); ++i)
    if (!has_child[i]) {
      leaves_.push_back(i);
      names_.push_back(skeleton_.bones[i].name + "/end");
    }
  if (!amc.empty()) motion_.emplace(amc, std::move(amc_file), skeleton_);
}

/// Positions of the points, and rotations of the bones that start there.
void AcclaimPoints::place(const std::vector<double>& values, std::vector<Vector3d>& p,
                          std::vector<Matrix3d>& R) const {
  const auto& bones = skeleton_.bones;
  R.resize(names_.size());
  std::vector<Vector3d> end(bones.size());
  p.resize(names_.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const AsfBone& bone = bones[i];
    Vector3d moved = Vector3d::Zero(), turned = Vector3d::Zero();
    for (const AsfChannel c : bone.channels)
      (c < AsfChannel::kRx ? moved : turned)[static_cast<int>(c) % 3] = values[k++];
    const Matrix3d own = bone.C * fixedAxesRotation(turned, bone.order) * bone.C.transpose();
    if (bone.parent < 0) {
      p[i] = skeleton_.position + moved;
      R[i] = own;
    } else {
      const auto parent = static_cast<std::size_t>(bone.parent);
      p[i] = end[parent];
      R[i] = R[parent] * own;
    }
    end[i] = p[i] + R[i] * bone.offset;
  }
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    p[bones.size() + i] = end[leaves_[i]];
    R[bones.size() + i] = R[leaves_[i]];
  }
}

std::vector<Vector3d> AcclaimPoints::rest() const {
  std::vector<Vector3d> p;
  std::vector<Matrix3d> R;
  place(std::vector<double>(channels_, 0.0), p, R);
  return p;
}

std::vector<int> AcclaimPoints::parents() const {
  std::vector<int> parents;
  for (const AsfBone& bone : skeleton_.bones) parents.push_back(bone.parent);
  for (const std::size_t leaf : leaves_) parents.push_back(static_cast<int>(leaf));
  return parents;
}

bool AcclaimPoints::next(PointFrame& frame) {
  if (motion_ ? !motion_->next(values_) : frames_ > 0) return false;
  if (!motion_) values_.assign(channels_, 0.0);
  place(values_, frame.p, frame.turn);
  frame.state.assign(frame.p.size(), humanmodel::JointState::kTracked);
  frame.t = static_cast<double>(frames_++) / kCmuRate;
  return true;
}

std::vector<FileWarning> AcclaimPoints::warnings() const {
  if (motion_) return motion_->warnings();
  return {
      {0, "an ASF holds a skeleton without motion: one frame in its rest pose; open the AMC for the motion"}};
}

}  // namespace abstand::tracking
