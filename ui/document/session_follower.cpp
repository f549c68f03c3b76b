#include "ui/document/session_follower.hpp"

#include <algorithm>

#include "core/base/error.hpp"
#include "ui/model/groups.hpp"
#include "ui/model/pair_class.hpp"

namespace abstand::ui {

namespace {

int dofOf(const view::SceneOutline& outline, const std::string& robot) {
  for (const view::RobotCard& card : outline.robots)
    if (card.name == robot) return card.joints;
  return 0;
}

}  // namespace

void SessionFollower::attach(SessionPort* port, const view::SceneSnapshot& first, const Work& work) {
  port_ = port;
  names_.clear();
  margins_.clear();
  pair_group_.clear();
  groups_.clear();
  group_of_name_.clear();
  if (!port_) return;
  for (const auto& object : port_->outline().objects) names_.push_back(QString::fromStdString(object.name));
  for (const view::ObjectSnapshot& object : first.objects) margins_.push_back(object.margin);
  margins_.resize(names_.size(), 0.0);
  pair_group_ = first.pair_group;
  pair_group_.resize(port_->outline().pairs.size(), -1);
  for (const std::string& name : port_->outline().pair_groups) {
    groups_.push_back(QString::fromStdString(name));
    group_of_name_.emplace(groups_.back(), static_cast<int>(groups_.size()) - 1);
  }
  follow({}, work);
}

void SessionFollower::follow(const Work& before, const Work& after) {
  if (!port_) return;
  if (before.margins != after.margins)
    for (int i = 0; i < static_cast<int>(names_.size()); ++i)
      if (margin(before, i) != margin(after, i)) port_->setMargin(i, margin(after, i));
  if (before.classes != after.classes) followClasses(before, after);
  if (before.moved != after.moved)
    for (int p = 0; p < static_cast<int>(pair_group_.size()); ++p) {
      const int from = group(before, p), to = group(after, p);
      if (from == to) continue;
      if (from >= 0) port_->removePair(p);
      if (to >= 0) port_->addPair(to, p);
    }
  if (before.groups != after.groups)
    for (int g = 0; g < static_cast<int>(groups_.size()); ++g)
      if (state(before, g) != state(after, g)) port_->setGroup(g, state(after, g));
  if (before.things != after.things) followThings(before, after);
  if (before.posed != after.posed) followPosed(before, after);
  if (before.reactions != after.reactions) followReactions(before, after);
}

void SessionFollower::followClasses(const Work& before, const Work& after) {
  for (std::size_t c = 0; c < view::kPairClassNames.size(); ++c) {
    const auto pair_class = static_cast<view::PairClass>(c);
    const std::optional<double> margin = classMargin(after, pair_class);
    if (margin != classMargin(before, pair_class)) port_->setClassMargin(pair_class, margin);
  }
}

void SessionFollower::followThings(const Work& before, const Work& after) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (!isThing(port_->outline().objects[i])) continue;
    const auto from = before.things.find(names_[i]), to = after.things.find(names_[i]);
    const bool was = from != before.things.end(), is = to != after.things.end();
    if (was == is && (!is || *from == *to)) continue;
    port_->placeThing(static_cast<int>(i), is ? std::optional(to->X_W()) : std::nullopt);
  }
}

void SessionFollower::followReactions(const Work& before, const Work& after) {
  const std::vector<std::string>& robots = port_->outline().reacting;
  for (int r = 0; r < static_cast<int>(port_->outline().reactions.size()); ++r) {
    const QString name = QString::fromStdString(robots[static_cast<std::size_t>(r)]);
    if (before.reactions.value(name) != after.reactions.value(name))
      port_->setReaction(r, reaction(after, r));
  }
}

control::ReactionDescription SessionFollower::reaction(const Work& work, int robot, QString* problem) const {
  const view::SceneOutline& outline = port_->outline();
  const auto r = static_cast<std::size_t>(robot);
  const int joints = dofOf(outline, outline.reacting[r]);
  const auto change = work.reactions.find(QString::fromStdString(outline.reacting[r]));
  if (change == work.reactions.end()) return outline.reactions[r];
  try {
    control::ReactionDescription changed = control::changedReaction(outline.reactions[r], *change, joints);
    const std::string unfit =
        r < outline.drives.size() ? view::driveProblem(outline.drives[r], changed) : std::string();
    if (!unfit.empty()) throw UsageError(unfit);
    return changed;
  } catch (const UsageError& e) {
    if (problem) *problem = QString::fromStdString(e.what());
    return outline.reactions[r];
  }
}

QVector<double> SessionFollower::posed(const Work& work, int robot) const {
  const view::RobotCard& card = port_->outline().robots[static_cast<std::size_t>(robot)];
  const QVector<double> joints = work.posed.value(QString::fromStdString(card.name));
  return joints.size() == card.joints ? joints : QVector<double>();
}

void SessionFollower::followPosed(const Work& before, const Work& after) {
  const auto& robots = port_->outline().robots;
  for (int r = 0; r < static_cast<int>(robots.size()); ++r) {
    const QVector<double> from = posed(before, r), to = posed(after, r);
    if (from == to) continue;
    if (to.isEmpty()) port_->followMotion(r);
    for (int k = 0; k < to.size(); ++k)
      if (from.isEmpty() || from[k] != to[k])
        port_->poseJoint(robots[static_cast<std::size_t>(r)].first_joint + k, to[k]);
  }
}

double SessionFollower::margin(const Work& work, int object) const {
  const auto i = static_cast<std::size_t>(object);
  return work.margins.value(names_[i], margins_[i]);
}

std::vector<double> SessionFollower::margins(const Work& work) const {
  std::vector<double> all(names_.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = margin(work, static_cast<int>(i));
  return all;
}

std::optional<double> SessionFollower::classMargin(const Work& work, view::PairClass pair_class) {
  const auto found = work.classes.find(pairClassKey(pair_class));
  return found == work.classes.end() ? std::optional<double>() : found->metres;
}

std::vector<double> SessionFollower::reviewMargins(const Work& work) const {
  std::vector<double> all = margins(work);
  const std::optional<double> own = classMargin(work, view::PairClass::kPersonRobot);
  if (!own) return all;
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = port_->outline().objects[i].human ? *own : 0.0;
  return all;
}

int SessionFollower::group(const Work& work, int pair) const {
  const auto p = static_cast<std::size_t>(pair);
  const auto [a, b] = port_->outline().pairs[p];
  const auto found =
      work.moved.find({names_[static_cast<std::size_t>(a)], names_[static_cast<std::size_t>(b)]});
  if (found == work.moved.end()) return pair_group_[p];
  const auto known = group_of_name_.find(*found);
  if (known != group_of_name_.end()) return known->second;
  return found->isEmpty() ? -1 : pair_group_[p];
}

view::PairGroupState SessionFollower::state(const Work& work, int group) const {
  return work.groups.value(groups_[static_cast<std::size_t>(group)], view::PairGroupState::kRunning);
}

QStringList SessionFollower::unknownNames(const Work& work) const {
  QSet<QString> objects, groups{QString()}, unknown;
  for (const QString& name : names_) objects.insert(name);
  for (const QString& name : groups_) groups.insert(name);
  const auto check = [&](const QSet<QString>& known, const QString& name) {
    if (!known.contains(name)) unknown.insert(name);
  };
  for (const QString& name : work.margins.keys()) check(objects, name);
  for (const QString& name : work.hidden) check(objects, name);
  for (const QString& name : work.locked) check(objects, name);
  if (work.compared)
    for (const QString& name : work.compared->keys()) check(objects, name);
  for (const QString& name : work.groups.keys()) check(groups, name);
  for (const QString& name : work.things.keys()) check(objects, name);
  QSet<QString> robots, people, reacting;
  for (const std::string& robot : port_->outline().reacting) reacting.insert(QString::fromStdString(robot));
  for (const QString& name : work.reactions.keys()) check(reacting, name);
  for (int r = 0; r < static_cast<int>(port_->outline().reactions.size()); ++r) {
    QString problem;
    reaction(work, r, &problem);
    if (!problem.isEmpty()) unknown.insert(problem);
  }
  for (const view::RobotCard& robot : port_->outline().robots)
    robots.insert(QString::fromStdString(robot.name));
  for (const view::PersonCard& person : port_->outline().people)
    people.insert(QString::fromStdString(person.name));
  for (const QString& name : work.posed.keys()) check(robots, name);
  for (const QString& name : work.people.keys()) check(people, name);
  for (const QString& name : work.placed.keys()) check(robots + people, name);
  for (const auto& pair : work.added) {
    check(objects, pair.first);
    check(objects, pair.second);
  }
  for (auto it = work.moved.begin(); it != work.moved.end(); ++it) {
    check(objects, it.key().first);
    check(objects, it.key().second);
    check(groups, it.value());
  }
  QStringList sorted = unknown.values();
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

}  // namespace abstand::ui
