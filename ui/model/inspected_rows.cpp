#include "ui/model/inspected_rows.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/roll_pitch_yaw.hpp"
#include "ui/model/body_state.hpp"
#include "ui/model/groups.hpp"
#include "ui/model/inspected_joints.hpp"
#include "ui/model/inspected_pairs.hpp"
#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

using Mark = InspectedRow::Mark;

/// Adds rows for one subject at one moment.
class Rows {
 public:
  Rows(const view::SceneOutline& scene, const view::SceneSnapshot& moment, std::vector<InspectedRow>& rows)
      : outline(scene), snapshot(moment), rows_(rows) {}

  void heading(const QString& name) { rows_.push_back({name, {}, Mark::kHeading}); }
  void add(const QString& name, const QString& value, Mark mark = Mark::kPlain) {
    rows_.push_back({name, value, mark});
  }
  QString name(int object) const {
    return QString::fromStdString(outline.objects[static_cast<std::size_t>(object)].name);
  }
  const view::ObjectSnapshot& at(int object) const {
    return snapshot.objects[static_cast<std::size_t>(object)];
  }

  const view::SceneOutline& outline;
  const view::SceneSnapshot& snapshot;

 private:
  std::vector<InspectedRow>& rows_;
};

Mark markOf(PairLevel level) {
  if (level == PairLevel::kTouching) return Mark::kAlarm;
  return level == PairLevel::kInside ? Mark::kInside : Mark::kPlain;
}

QString poseStateText(const view::ObjectSnapshot& object) {
  switch (object.pose_state) {
    case scene::PoseState::kFresh:
      return object.pose_uncertainty > 0.0 ? tr("known within %1").arg(lengthText(object.pose_uncertainty))
                                           : tr("known");
    case scene::PoseState::kInferred:
      return tr("inferred, within %1").arg(lengthText(object.pose_uncertainty));
    case scene::PoseState::kStale:
      return tr("? lost: where it was last seen");
    case scene::PoseState::kRejected:
      return tr("? refused: the last good one is shown");
  }
  return {};
}

/// `of`: whose pose, where it is not that of the subject itself.
void addPose(Rows& rows, const Transform& X, const QString& of = {}) {
  const Vector3d p = X.translation(), angles = rollPitchYaw(X.linear());
  rows.add(of.isEmpty() ? tr("Position") : tr("Position, %1").arg(of),
           tr("x %1, y %2, z %3 m").arg(fixed(p.x(), 3), fixed(p.y(), 3), fixed(p.z(), 3)));
  rows.add(of.isEmpty() ? tr("Roll, pitch, yaw") : tr("Roll, pitch, yaw, %1").arg(of),
           tr("%1, %2, %3").arg(angleText(angles.x()), angleText(angles.y()), angleText(angles.z())));
}

void addBody(Rows& rows, int object) {
  const auto& info = rows.outline.objects[static_cast<std::size_t>(object)];
  const QString group = QString::fromStdString(info.group);
  rows.add(tr("Kind"), info.human                ? tr("body part of the person %1").arg(group)
                       : info.group == "objects" ? tr("thing in the room")
                                                 : tr("link of the robot %1").arg(group));
  const view::ObjectSnapshot& now = rows.at(object);
  addPose(rows, now.X_WB);
  rows.add(tr("Speed"),
           tr("%1 m/s, turns at %2/s")
               .arg(fixed(now.velocity.linear.norm(), 3), angleText(now.velocity.angular.norm())));
  const bool lost = scene::isPoseLost(now.pose_state);
  rows.add(tr("Pose"), poseStateText(now), lost ? Mark::kAlarm : Mark::kPlain);
  rows.add(tr("Margin"), lengthText(now.margin, 0));
  std::vector<BodyState> states;
  findBodyStates(rows.outline, rows.snapshot, states);
  const BodyState& state = states[static_cast<std::size_t>(object)];
  const auto force = [&](const QString& name, const Vector3d& sum) {
    if (sum.norm() > 0.0) rows.add(name, tr("%1 N, all pairs").arg(fixed(sum.norm(), 1)));
  };
  force(tr("Contact force"), state.contact_force);
  force(tr("Virtual (margin) force"), state.virtual_force);
}

void addGeometry(Rows& rows, int object) {
  if (static_cast<std::size_t>(object) >= rows.outline.bodies.size()) return;
  const view::BodyCard& card = rows.outline.bodies[static_cast<std::size_t>(object)];
  rows.heading(tr("Geometry"));
  rows.add(
      tr("Size"),
      tr("%1 × %2 × %3 m").arg(fixed(card.size.x(), 3), fixed(card.size.y(), 3), fixed(card.size.z(), 3)));
  rows.add(tr("Shell points"), tr("%1, %2 apart").arg(card.shell_points).arg(lengthText(card.point_spacing)));
  rows.add(tr("Voxels"), lengthText(card.voxel_size));
  rows.add(tr("Error bound"), lengthText(card.error_bound));
}

void addFastest(Rows& rows, const std::vector<int>& objects) {
  const auto speed = [&](int object) { return rows.at(object).velocity.linear.norm(); };
  const int which =
      *std::max_element(objects.begin(), objects.end(), [&](int a, int b) { return speed(a) < speed(b); });
  rows.add(tr("Fastest body"), tr("%1 m/s, %2").arg(fixed(speed(which), 3), rows.name(which)));
}

void addRobot(Rows& rows, int index) {
  const view::RobotCard& card = rows.outline.robots[static_cast<std::size_t>(index)];
  rows.add(tr("Kind"), tr("robot with %1 joints").arg(card.joints));
  addPose(rows, card.X_WB, tr("base"));
  rows.add(tr("Motion"), robotMotionText(rows.outline, rows.snapshot, index));
}

void addPerson(Rows& rows, int index, const std::vector<int>& parts) {
  const view::PersonCard& card = rows.outline.people[static_cast<std::size_t>(index)];
  rows.add(tr("Kind"), tr("person of %1 body parts").arg(parts.size()));
  rows.add(tr("Stature"), tr("%1 m").arg(fixed(card.stature, 3)));
  rows.add(tr("Mass"), tr("%1 kg").arg(fixed(card.mass, 1)));
  rows.add(tr("Sex"), card.sex == "f"   ? tr("female")
                      : card.sex == "m" ? tr("male")
                                        : tr("not given: mean of both"));
  rows.add(tr("Sizes"), card.percentile ? tr("percentile %1").arg(fixed(*card.percentile, 1)) : tr("mean"));
  rows.add(tr("Recording"), card.recording.empty() ? tr("none: stands still")
                                                   : QString::fromStdString(card.recording).section('/', -1));
  const auto i = static_cast<std::size_t>(index);
  if (!card.recording.empty() && i < rows.snapshot.movers.person_age.size())
    rows.add(tr("Oldest part seen"), tr("%1 ago").arg(secondsWithUnit(rows.snapshot.movers.person_age[i])));
  if (parts.empty()) return;
  const auto first = static_cast<std::size_t>(parts.front());
  addPose(rows, rows.at(parts.front()).X_WB, QString::fromStdString(shortName(rows.outline.objects[first])));
}

void addPair(Rows& rows, int index) {
  const auto p = static_cast<std::size_t>(index);
  const view::PairSnapshot& now = rows.snapshot.pairs[p];
  const PairLevel level = pairLevel(rows.snapshot, now, rows.outline.pairs[p]);
  const QString state = levelText(level);
  if (now.paused) {
    rows.add(tr("State"), state);
    rows.add(tr("When last checked"), lengthText(now.result.distance));
    return;
  }
  rows.add(tr("Distance"),
           tr("%1, uncertainty %2").arg(lengthText(now.result.distance), lengthText(now.result.bound)));
  rows.add(tr("At least"), lengthText(now.result.distance - now.result.bound));
  const double unknown = poseUncertainty(rows.snapshot, rows.outline.pairs[p]);
  rows.add(tr("Margin"),
           unknown > 0.0
               ? tr("%1 and %2 for the poses").arg(lengthText(now.margin, 0), lengthText(unknown, 0))
               : lengthText(now.margin, 0));
  rows.add(tr("State"), state, markOf(level));
  const ForceKind kind = forceKind(now.result);
  if (kind != ForceKind::kNone)
    rows.add(kind == ForceKind::kContact ? tr("Contact force") : tr("Virtual (margin) force"),
             tr("%1 N").arg(fixed(now.result.force_a.norm(), 1)));
}

void addPairs(Rows& rows, const std::vector<int>& objects, const QString& person, const QString& other) {
  const InspectedPairs found = inspectPairs(rows.outline, rows.snapshot, objects);
  rows.heading(tr("Distances"));
  const auto names = [&](int index) {
    const auto [a, b] = rows.outline.pairs[static_cast<std::size_t>(index)];
    const bool first = std::binary_search(objects.begin(), objects.end(), a);
    return objects.size() > 1 ? tr("%1 – %2").arg(rows.name(first ? a : b), rows.name(first ? b : a))
                              : rows.name(first ? b : a);
  };
  rows.add(tr("State"), found.pairs == 0 ? tr("? not checked") : levelText(found.level), markOf(found.level));
  if (found.heaviest >= 0 && found.level != PairLevel::kApart)
    rows.add(tr("Because of"), names(found.heaviest));
  rows.add(tr("Checked"), tr("%1 pairs").arg(found.pairs - found.paused));
  rows.add(tr("Not checked"), uncheckedText(found));
  for (const auto& reason : uncheckedReasons(found))
    rows.add(QStringLiteral("   ") + reason.first, QString::number(reason.second));
  const auto partner = [&](const QString& title, int index) {
    if (index < 0) return;
    rows.heading(title);
    rows.add(tr("Body"), names(index));
    addPair(rows, index);
  };
  partner(person, found.nearest_person);
  partner(other, found.nearest_other);
}

}  // namespace

std::vector<InspectedRow> inspectedRows(const view::SceneOutline& outline,
                                        const view::SceneSnapshot& snapshot,
                                        const InspectedSubject& subject) {
  std::vector<InspectedRow> rows;
  if (subject.kind == SubjectKind::kNone || snapshot.objects.size() != outline.objects.size() ||
      snapshot.pairs.size() != outline.pairs.size())
    return rows;
  Rows write(outline, snapshot, rows);
  const QString person = tr("Nearest person"), other = tr("Nearest robot or thing");
  switch (subject.kind) {
    case SubjectKind::kNone:
      break;
    case SubjectKind::kBody:
      addBody(write, subject.objects.front());
      addPairs(write, subject.objects, person, other);
      addGeometry(write, subject.objects.front());
      break;
    case SubjectKind::kPair:
      write.heading(tr("Pair"));
      addPair(write, subject.pair);
      for (const int object : subject.objects) {
        write.heading(QString::fromStdString(outline.objects[static_cast<std::size_t>(object)].name));
        addBody(write, object);
      }
      break;
    case SubjectKind::kRobot:
      addRobot(write, subject.robot);
      addFastest(write, subject.objects);
      addPairs(write, subject.objects, person, other);
      break;
    case SubjectKind::kPerson:
      addPerson(write, subject.person, subject.objects);
      addFastest(write, subject.objects);
      addPairs(write, subject.objects, person, other);
      break;
    case SubjectKind::kSeveral:
      addFastest(write, subject.objects);
      addPairs(write, subject.objects, person, other);
      break;
  }
  if (subject.robot >= 0) {
    write.heading(tr("Joints"));
    for (const InspectedRow& row : jointRows(outline, snapshot, subject.robot)) rows.push_back(row);
  }
  return rows;
}

}  // namespace abstand::ui
