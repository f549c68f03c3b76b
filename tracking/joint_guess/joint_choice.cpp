#include "tracking/joint_guess/joint_choice.hpp"

#include <algorithm>

#include "core/base/data_folder.hpp"
#include "core/text/message_text.hpp"
#include "tracking/joint_guess/guess_check.hpp"
#include "tracking/joint_guess/guess_fill.hpp"
#include "tracking/joint_guess/name_guess.hpp"
#include "tracking/joint_guess/neck_choice.hpp"
#include "tracking/joint_guess/point_tree.hpp"
#include "tracking/recording/map_misses.hpp"

namespace abstand::tracking {
namespace {

constexpr const char* kByNames = "guessed from the names";
constexpr const char* kByShape = "guessed from the shape";

/// Mean of several points; missing if one of them is missing, inferred if one of them is inferred.
void setMean(const PointFrame& from, const std::vector<int>& points, humanmodel::Joint j,
             humanmodel::SkeletonFrame& to) {
  Vector3d sum = Vector3d::Zero();
  humanmodel::JointState state = humanmodel::JointState::kTracked;
  double spread = 0.0;
  for (const int i : points) {
    sum += from.p[static_cast<std::size_t>(i)];
    spread = std::max(spread, from.spreadOf(static_cast<std::size_t>(i)));
    state = std::min(state, from.state[static_cast<std::size_t>(i)]);
  }
  if (state == humanmodel::JointState::kMissing) return;
  to.set(j, sum / static_cast<double>(points.size()), state);
  to.spread[static_cast<std::size_t>(j)] = spread;
}

/// Frames of a match, and its rest pose.
std::vector<humanmodel::SkeletonFrame> pickAll(const SkeletonSample& skeleton, const JointMatch& match) {
  std::vector<humanmodel::SkeletonFrame> all;
  for (const PointFrame& f : skeleton.frames) all.push_back(pickJoints(f, match));
  return all;
}

JointChoice choiceByNames(const SkeletonSample& skeleton) {
  JointChoice choice;
  choice.match = guessByNames(skeleton.names, !skeleton.parents.empty());
  choice.match.map = kByNames;
  choice.is_guess = true;
  raiseNeck(skeleton.parents, skeleton.rest, choice.match);
  choice.notes = removeImplausible(choice.match, pickAll(skeleton, choice.match));
  choice.reason = std::to_string(limbJoints(choice.match)) +
                  " of 12 joints of the limbs by sides and segments in their names";
  return choice;
}

JointChoice choiceByShape(const SkeletonSample& skeleton) {
  ShapeGuess guess =
      skeleton.parents.empty() ? guessByMotion(skeleton.names, skeleton.frames) : guessByShape(skeleton);
  JointChoice choice;
  choice.match = std::move(guess.match);
  raiseNeck(skeleton.parents, skeleton.rest, choice.match);
  choice.match.map = kByShape;
  choice.is_guess = true;
  choice.reason = std::move(guess.reason);
  return choice;
}

/// Takes the guess instead of the choice, or fills the choice from it.
void useGuess(const SkeletonSample& skeleton, JointChoice guess, const char* how, JointChoice& best) {
  if (limbJoints(best.match) < kEnoughLimbJoints && limbJoints(guess.match) > limbJoints(best.match)) {
    best = std::move(guess);
    return;
  }
  if (limbJoints(best.match) == 0) return;
  const bool had_pelvis = best.match.joint[static_cast<std::size_t>(humanmodel::Joint::kPelvis)] >= 0;
  auto added = fillFrom(best.match, guess.match);
  if (!had_pelvis) {
    removeDistantPelvis(best.match, pickAll(skeleton, best.match));
    std::erase_if(added,
                  [&](humanmodel::Joint j) { return best.match.joint[static_cast<std::size_t>(j)] < 0; });
  }
  if (added.empty()) return;
  std::string joints;
  for (const humanmodel::Joint j : added)
    joints += (joints.empty() ? "" : ", ") + std::string(humanmodel::jointName(j)) + " " +
              text::inQuotes(
                  skeleton.names[static_cast<std::size_t>(best.match.joint[static_cast<std::size_t>(j)])]);
  best.filled += (best.filled.empty() ? "" : "; ") + joints + " " + how;
}

/// By the names, then by the shape, as far as joints are missing.
void guessMissing(const SkeletonSample& skeleton, JointChoice& best) {
  if (!isIncomplete(best.match)) return;
  std::vector<std::string> notes;
  JointChoice by_names = choiceByNames(skeleton);
  if (limbJoints(best.match) < kEnoughLimbJoints) notes = by_names.notes;
  useGuess(skeleton, std::move(by_names), "by the names", best);
  if (limbJoints(best.match) < kLimbJointCount) {
    JointChoice by_shape = choiceByShape(skeleton);
    const std::string reason = by_shape.reason;
    useGuess(skeleton, std::move(by_shape), "by the shape", best);
    if (limbJoints(best.match) == 0)
      notes.push_back("the joints cannot be guessed from the shape of the skeleton: " + reason);
  }
  best.notes = std::move(notes);
}

}  // namespace

humanmodel::SkeletonFrame pickJoints(const PointFrame& from, const JointMatch& match) {
  humanmodel::SkeletonFrame frame;
  frame.t = from.t;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    if (match.joint[j] < 0) continue;
    const auto i = static_cast<std::size_t>(match.joint[j]);
    if (i >= from.p.size())
      setMean(from, match.means[i - from.p.size()], static_cast<humanmodel::Joint>(j), frame);
    else if (from.state[i] != humanmodel::JointState::kMissing) {
      frame.set(static_cast<humanmodel::Joint>(j), from.p[i], from.state[i]);
      frame.spread[j] = from.spreadOf(i);
      if (!from.covariance.empty()) frame.covariance[j] = from.covarianceOf(i);
      if (!from.lateral.empty()) frame.lateral[j] = from.lateral[i];
    }
  }
  return frame;
}

JointChoice chooseJoints(const SkeletonSample& skeleton, const RecordingOptions& options, bool may_guess) {
  const bool is_user = !options.joint_map.empty();
  const auto maps = is_user ? std::vector<JointMap>{loadJointMap(options.joint_map)}
                            : loadJointMaps(dataFolder() / "joint_maps");
  JointChoice best;
  best.match = chooseJointMap(maps, skeleton.names);
  best.reason = is_user ? "given by the user"
                        : "it finds " + std::to_string(best.match.mapped) + " joints, the most of all maps";
  if (is_user) best.misses = missesOf(maps.front(), best.match, skeleton.names);
  if (!is_user && may_guess) guessMissing(skeleton, best);
  if (best.match.mapped == 0) {
    best.match.map.clear();
    best.is_guess = false;
    best.reason = is_user ? "the given map matches no joint" : "no map matches the names";
  }
  return best;
}

}  // namespace abstand::tracking
