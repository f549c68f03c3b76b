// Groups and their objects.
#include "ui/model/scene_tree_model.hpp"

#include <QBrush>
#include <QFont>
#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "ui/model/pair_class.hpp"
#include "ui/model/watched_series.hpp"
#include "ui/style/format.hpp"
#include "ui/style/icons.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

namespace {

// The internal id of a group's index; that of an object's index is its group's number.
constexpr quintptr kIsGroup = ~quintptr{0};
// A distance is shown again when it moved by a tenth of a millimetre, the last digit that is shown.
constexpr double kShownStep = 0.5e-4;

bool sameShown(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::abs(a - b) < kShownStep;
}

}  // namespace

SceneTreeModel::SceneTreeModel(QObject* parent) : QAbstractItemModel(parent) {
  connect(&Units::shown(), &Units::changed, this, [this] {
    for (int group = 0; group < rowCount(); ++group) {
      const QModelIndex top = index(group, 0);
      const int rows = rowCount(top);
      if (rows > 0) Q_EMIT dataChanged(index(0, 1, top), index(rows - 1, 1, top));
    }
  });
}

void SceneTreeModel::open(const view::SceneOutline& outline) {
  beginResetModel();
  groups_ = groupsOf(outline);
  rows_.assign(outline.objects.size(), {});
  nearest_.assign(outline.objects.size(), kNaN);
  of_people_ = std::any_of(outline.pairs.begin(), outline.pairs.end(), [&](const auto& pair) {
    return pairClassOf(outline, pair) == PairClass::kPersonRobot;
  });
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    for (std::size_t r = 0; r < groups_[g].objects.size(); ++r) {
      const int object = groups_[g].objects[r];
      Row& row = rows_[static_cast<std::size_t>(object)];
      const auto& info = outline.objects[static_cast<std::size_t>(object)];
      row.name = QString::fromStdString(shortName(info));
      row.full_name = QString::fromStdString(info.name);
      row.group = static_cast<int>(g);
      row.row = static_cast<int>(r);
    }
  }
  endResetModel();
}

void SceneTreeModel::refresh(const view::SceneOutline& outline, const view::SceneSnapshot& snapshot) {
  if (snapshot.objects.size() != rows_.size()) return;
  shown_step_ = snapshot.step;
  std::fill(nearest_.begin(), nearest_.end(), kNaN);
  findBodyStates(outline, snapshot, states_);
  for (std::size_t p = 0; p < std::min(snapshot.pairs.size(), outline.pairs.size()); ++p) {
    const PairClass of = pairClassOf(outline, outline.pairs[p]);
    const bool counts = !of_people_ || of == PairClass::kPersonRobot || of == PairClass::kPersonThing;
    const double d = counts ? snapshot.pairs[p].result.distance : kNaN;
    for (const int object : {outline.pairs[p].first, outline.pairs[p].second}) {
      double& nearest = nearest_[static_cast<std::size_t>(object)];
      nearest = std::fmin(nearest, d);
    }
  }
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    bool group_changed = false;
    const QModelIndex parent = index(static_cast<int>(g), 0);
    for (const int object : groups_[g].objects) {
      const auto i = static_cast<std::size_t>(object);
      const view::ObjectSnapshot& now = snapshot.objects[i];
      Row& row = rows_[i];
      const bool hollow = scene::isPoseLost(now.pose_state);
      const PairLevel level = isBroken(states_[i].level) ? states_[i].level : PairLevel::kApart;
      if (row.level == level && row.hollow == hollow && sameShown(row.distance, nearest_[i])) continue;
      group_changed |= row.level != level;
      row.level = level;
      row.hollow = hollow;
      row.distance = nearest_[i];
      Q_EMIT dataChanged(index(row.row, 0, parent), index(row.row, 1, parent));
    }
    if (group_changed) Q_EMIT dataChanged(parent, parent.siblingAtColumn(1));
  }
}

void SceneTreeModel::setTheme(Theme theme) {
  theme_ = theme;
  if (!groups_.empty()) Q_EMIT dataChanged(index(0, 0), index(static_cast<int>(groups_.size()) - 1, 1));
}

std::vector<int> SceneTreeModel::objectsOf(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  if (index.internalId() == kIsGroup) return groups_[static_cast<std::size_t>(index.row())].objects;
  return {groups_[index.internalId()].objects[static_cast<std::size_t>(index.row())]};
}

QModelIndex SceneTreeModel::indexOf(int object) const {
  if (object < 0 || static_cast<std::size_t>(object) >= rows_.size()) return {};
  const Row& row = rows_[static_cast<std::size_t>(object)];
  return createIndex(row.row, 0, static_cast<quintptr>(row.group));
}

QModelIndex SceneTreeModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) : kIsGroup);
}

QModelIndex SceneTreeModel::parent(const QModelIndex& child) const {
  if (!child.isValid() || child.internalId() == kIsGroup) return {};
  return createIndex(static_cast<int>(child.internalId()), 0, kIsGroup);
}

int SceneTreeModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(groups_.size());
  if (parent.internalId() != kIsGroup || parent.column() != 0) return 0;
  return static_cast<int>(groups_[static_cast<std::size_t>(parent.row())].objects.size());
}

int SceneTreeModel::columnCount(const QModelIndex&) const { return 2; }

QColor SceneTreeModel::colour(const Group& group) const {
  switch (group.kind) {
    case GroupKind::kHuman:
      return sceneColours(theme_).human;
    case GroupKind::kObjects:
      return sceneColours(theme_).objects;
    case GroupKind::kMechanism:
      break;
  }
  return mechanismColour(group.index_of_kind, theme_);
}

QVariant SceneTreeModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (index.internalId() == kIsGroup) return groupData(index, role);
  return objectData(objectsOf(index).front(), index.column(), role);
}

QVariant SceneTreeModel::groupData(const QModelIndex& index, int role) const {
  const Group& group = groups_[static_cast<std::size_t>(index.row())];
  const auto count = [&](PairLevel level) {
    return std::count_if(group.objects.begin(), group.objects.end(),
                         [&](int o) { return rows_[static_cast<std::size_t>(o)].level == level; });
  };
  const auto touching = count(PairLevel::kTouching), inside = count(PairLevel::kInside);
  const auto shown = std::count_if(group.objects.begin(), group.objects.end(),
                                   [&](int o) { return rows_[static_cast<std::size_t>(o)].visible; });
  if (index.column() == 0) {
    if (role == Qt::DisplayRole) return groupTitle(group);
    if (role == Qt::DecorationRole) return swatch(colour(group));
    if (role == Qt::CheckStateRole) {
      if (shown == 0) return Qt::Unchecked;
      return static_cast<std::size_t>(shown) == group.objects.size() ? Qt::Checked : Qt::PartiallyChecked;
    }
    if (role == Qt::FontRole) {
      QFont font = QGuiApplication::font();
      font.setBold(true);
      return font;
    }
    if (role == Qt::ToolTipRole) {
      switch (group.kind) {
        case GroupKind::kMechanism:
          return tr("Mechanism, links: %1").arg(group.objects.size());
        case GroupKind::kHuman:
          return tr("Person, body parts: %1").arg(group.objects.size());
        case GroupKind::kObjects:
          return tr("In the room: %1").arg(group.objects.size());
      }
    }
    return {};
  }
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (touching + inside == 0) return {};
  if (role == Qt::DisplayRole) return QStringLiteral("⚠ %1").arg(touching + inside);
  if (role == Qt::ToolTipRole) return tr("Touching: %1, inside margins: %2").arg(touching).arg(inside);
  if (role == Qt::ForegroundRole)
    return QBrush(levelColour(touching > 0 ? PairLevel::kTouching : PairLevel::kInside));
  return {};
}

QVariant SceneTreeModel::objectData(int object, int column, int role) const {
  const Row& row = rows_[static_cast<std::size_t>(object)];
  if (role == Qt::ToolTipRole) {
    if (sentence_) return sentence_(object);
    QString tip = row.full_name;
    if (row.hollow)
      tip += QLatin1Char('\n') + tr("The pose is stale or was rejected: drawn hollow, never safe");
    return tip;
  }
  if (column == 0) {
    if (role == Qt::DisplayRole) return row.name;
    if (role == Qt::CheckStateRole) return row.visible ? Qt::Checked : Qt::Unchecked;
    return {};
  }
  switch (role) {
    case Qt::DisplayRole:
      if (isBroken(row.level)) return levelText(row.level);
      if (row.hollow) return tr("pose lost");
      return std::isnan(row.distance) ? QString() : lengthText(row.distance);
    case Qt::ForegroundRole:
      if (isBroken(row.level)) return QBrush(levelColour(row.level));
      return QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
    case Qt::TextAlignmentRole:
      return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    default:
      return {};
  }
}

bool SceneTreeModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != 0 || role != Qt::CheckStateRole) return false;
  const bool visible = value.toInt() != Qt::Unchecked;
  const std::vector<int> objects = objectsOf(index);
  for (const int object : objects) setVisible(object, visible);
  Q_EMIT visibilityEdited(objects, visible);
  return true;
}

void SceneTreeModel::setVisible(int object, bool visible) {
  Row& row = rows_[static_cast<std::size_t>(object)];
  if (row.visible == visible) return;
  row.visible = visible;
  const QModelIndex changed = indexOf(object);
  Q_EMIT dataChanged(changed, changed);
  Q_EMIT dataChanged(changed.parent(), changed.parent());
  Q_EMIT visibilityChanged(object, visible);
}

QVariant SceneTreeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (section == 1 && role == Qt::ToolTipRole)
    return of_people_
               ? tr("Of a robot or a thing: to the nearest person. Of a person: to the nearest object.")
               : tr("To the nearest object");
  if (role != Qt::DisplayRole) return {};
  return section == 0 ? tr("Object") : tr("Nearest");
}

Qt::ItemFlags SceneTreeModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled;
  if (index.column() == 0) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

QMimeData* SceneTreeModel::mimeData(const QModelIndexList& indexes) const {
  std::vector<Watched> bodies;
  for (const QModelIndex& index : indexes)
    for (const int object : objectsOf(index)) {
      const Watched body{Watched::Kind::kBody, object};
      if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) bodies.push_back(body);
    }
  return mimeOf(bodies);
}

}  // namespace abstand::ui
