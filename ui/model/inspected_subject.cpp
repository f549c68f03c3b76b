#include "ui/model/inspected_subject.hpp"

#include <algorithm>

#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

template <class Card>
int indexOfName(const std::vector<Card>& cards, const std::string& name) {
  const auto at = std::find_if(cards.begin(), cards.end(), [&](const Card& c) { return c.name == name; });
  return at == cards.end() ? -1 : static_cast<int>(at - cards.begin());
}

const view::SceneOutline::ObjectInfo& infoOf(const view::SceneOutline& outline, int object) {
  return outline.objects[static_cast<std::size_t>(object)];
}

}  // namespace

InspectedSubject inspectedSubject(const view::SceneOutline& outline, const std::vector<int>& objects,
                                  int pair) {
  InspectedSubject subject;
  subject.objects = objects;
  const auto known = static_cast<int>(outline.objects.size());
  std::erase_if(subject.objects, [&](int object) { return object < 0 || object >= known; });
  if (subject.objects.empty()) return subject;
  if (pair >= 0 && static_cast<std::size_t>(pair) < outline.pairs.size()) {
    subject.kind = SubjectKind::kPair;
    subject.pair = pair;
    return subject;
  }
  subject.kind = subject.objects.size() == 1 ? SubjectKind::kBody : SubjectKind::kSeveral;
  const std::string& group = infoOf(outline, subject.objects.front()).group;
  const bool one_group = std::all_of(subject.objects.begin(), subject.objects.end(),
                                     [&](int object) { return infoOf(outline, object).group == group; });
  if (!one_group) return subject;
  subject.robot = indexOfName(outline.robots, group);
  subject.person = indexOfName(outline.people, group);
  const auto whole = std::count_if(outline.objects.begin(), outline.objects.end(),
                                   [&](const auto& info) { return info.group == group; });
  if (subject.objects.size() == 1 || whole != static_cast<std::ptrdiff_t>(subject.objects.size()))
    return subject;
  if (subject.robot >= 0) subject.kind = SubjectKind::kRobot;
  if (subject.person >= 0) subject.kind = SubjectKind::kPerson;
  return subject;
}

QString subjectTitle(const view::SceneOutline& outline, const InspectedSubject& subject) {
  const auto name = [&](int object) { return QString::fromStdString(infoOf(outline, object).name); };
  switch (subject.kind) {
    case SubjectKind::kNone:
      return tr("Nothing is selected");
    case SubjectKind::kBody:
      return name(subject.objects.front());
    case SubjectKind::kPair: {
      const auto [a, b] = outline.pairs[static_cast<std::size_t>(subject.pair)];
      return QStringLiteral("%1 – %2").arg(name(a), name(b));
    }
    case SubjectKind::kRobot:
    case SubjectKind::kPerson:
      return QString::fromStdString(infoOf(outline, subject.objects.front()).group);
    case SubjectKind::kSeveral:
      break;
  }
  return tr("%1 bodies").arg(subject.objects.size());
}

bool isByHand(const view::SceneSnapshot& snapshot, int robot) {
  return robot >= 0 && static_cast<std::size_t>(robot) < snapshot.movers.by_hand.size() &&
         snapshot.movers.by_hand[static_cast<std::size_t>(robot)];
}

int robotOf(const view::SceneOutline& outline, const std::string& name) {
  return indexOfName(outline.robots, name);
}

}  // namespace abstand::ui
