// The checked pairs with their latest results.
#include "ui/model/pair_table_model.hpp"

#include <QBrush>
#include <QFont>
#include <QGuiApplication>
#include <algorithm>
#include <cmath>

#include "ui/model/watched_series.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"
#include "ui/style/units.hpp"

namespace abstand::ui {

PairTableModel::PairTableModel(QObject* parent) : QAbstractTableModel(parent) {
  connect(&Units::shown(), &Units::changed, this, [this] {
    Q_EMIT headerDataChanged(Qt::Horizontal, kDistance, kMargin);
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, kDistance), index(rowCount() - 1, kMargin));
  });
}

void PairTableModel::open(const view::SceneOutline& outline) {
  beginResetModel();
  names_.clear();
  for (const auto& info : outline.objects) names_.push_back(QString::fromStdString(info.name));
  pairs_ = outline.pairs;
  classes_.clear();
  for (const auto& pair : pairs_) classes_.push_back(pairClassOf(outline, pair));
  values_.assign(pairs_.size(), {});
  levels_.assign(pairs_.size(), PairLevel::kUnknown);
  uncertainty_.assign(pairs_.size(), 0.0);
  endResetModel();
}

void PairTableModel::refresh(const view::SceneSnapshot& snapshot) {
  if (snapshot.pairs.size() != values_.size() || snapshot.objects.size() != names_.size() || values_.empty())
    return;
  std::copy(snapshot.pairs.begin(), snapshot.pairs.end(), values_.begin());
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    levels_[i] = pairLevel(snapshot, values_[i], pairs_[i]);
    uncertainty_[i] = poseUncertainty(snapshot, pairs_[i]);
  }
  shown_step_ = snapshot.step;
}

void PairTableModel::announce(int row) { Q_EMIT dataChanged(index(row, 0), index(row, kColumns - 1)); }

int PairTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(pairs_.size());
}

int PairTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant PairTableModel::text(std::size_t row, int column) const {
  const view::PairSnapshot& pair = values_[row];
  switch (column) {
    case kState:
      return levelText(levels_[row]);
    case kA:
      return names_[static_cast<std::size_t>(pairs_[row].first)];
    case kB:
      return names_[static_cast<std::size_t>(pairs_[row].second)];
    case kDistance:
      return pair.paused ? tr("–") : lengthNumber(pair.result.distance);
    case kUncertainty:
      if (pair.paused) return tr("–");
      if (std::isinf(uncertainty_[row])) return tr("pose unknown");
      return lengthNumber(pair.result.bound + uncertainty_[row]);
    case kMargin:
      return lengthNumber(pair.margin, 0);
    case kForce:
      if (pair.paused) return tr("–");
      return forceKind(pair.result) == ForceKind::kVirtual
                 ? tr("%1 virtual").arg(fixed(pair.result.force_a.norm(), 1))
                 : fixed(pair.result.force_a.norm(), 1);
    case kPoints:
      return pair.paused ? tr("–") : QString::number(pair.result.contacts);
    default:
      return {};
  }
}

double PairTableModel::number(std::size_t row, int column) const {
  const view::PairSnapshot& pair = values_[row];
  const auto finite = [](double v) { return std::isnan(v) ? kInfinity : v; };
  switch (column) {
    case kState:
      return -static_cast<double>(levels_[row]);
    case kDistance:
      // What is not checked may be the nearest of all.
      return pair.paused ? -kInfinity : finite(pair.result.distance);
    case kUncertainty:
      return finite(pair.result.bound + uncertainty_[row]);
    case kMargin:
      return pair.margin;
    case kForce:
      return pair.result.force_a.norm();
    default:
      return pair.result.contacts;
  }
}

QVariant PairTableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto row = static_cast<std::size_t>(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return text(row, index.column());
    case kSortRole:
      if (index.column() == kA || index.column() == kB) return text(row, index.column());
      return number(row, index.column());
    case Qt::TextAlignmentRole:
      return static_cast<int>((index.column() >= kDistance ? Qt::AlignRight : Qt::AlignLeft) |
                              Qt::AlignVCenter);
    case Qt::BackgroundRole: {
      const PairLevel now = levels_[row];
      if (now == PairLevel::kApart || now == PairLevel::kUnknown) return {};
      QColor tint = levelColour(now);
      tint.setAlpha(isBroken(now) ? 60 : 36);
      return QBrush(tint);
    }
    case Qt::FontRole:
      if (index.column() == kState && levels_[row] == PairLevel::kTouching) {
        QFont font = QGuiApplication::font();
        font.setBold(true);
        return font;
      }
      return {};
    case Qt::ToolTipRole:
      return sentence_ ? sentence_(index.row()) : QVariant();
    default:
      return {};
  }
}

Qt::ItemFlags PairTableModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.isValid() ? flags | Qt::ItemIsDragEnabled : flags;
}

QMimeData* PairTableModel::mimeData(const QModelIndexList& indexes) const {
  std::vector<Watched> pairs;
  for (const QModelIndex& index : indexes) {
    const Watched pair{Watched::Kind::kPair, index.row()};
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) pairs.push_back(pair);
  }
  return mimeOf(pairs);
}

QVariant PairTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((section >= kDistance ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::DisplayRole) {
    switch (section) {
      case kState:
        return tr("State");
      case kA:
        return tr("A");
      case kB:
        return tr("B");
      case kDistance:
        return tr("Distance [%1]").arg(lengthUnit());
      case kUncertainty:
        return tr("Uncertainty [%1]").arg(lengthUnit());
      case kMargin:
        return tr("Margin [%1]").arg(lengthUnit());
      case kForce:
        return tr("Force [N]");
      case kPoints:
        return tr("Shell points");
      default:
        return {};
    }
  }
  if (role == Qt::ToolTipRole) {
    switch (section) {
      case kState:
        return tr(
            "Touching: it is not certain that the surfaces are apart. Inside margin: nothing touches, but "
            "it is not certain that the margins are kept. Near: closer than twice the margins. "
            "Pose lost: the distance is that of an old pose. Not checked: their group does not run.");
      case kDistance:
        return tr("Between the bare surfaces, negative inside");
      case kUncertainty:
        return tr(
            "Error bound of the surfaces plus the uncertainty of both poses. The distance minus this is what "
            "is compared with the margin");
      case kMargin:
        return tr("Sum of both objects' safety margins");
      case kForce:
        return tr("Contact force where the two touch; virtual: of the margins alone, nothing touches");
      case kPoints:
        return tr("Points of the one's shell that are inside the margin of the other, or inside of it");
      default:
        return {};
    }
  }
  return {};
}

PairFilter::PairFilter(QObject* parent) : QSortFilterProxyModel(parent) {
  setSortRole(PairTableModel::kSortRole);
  setDynamicSortFilter(false);
}

void PairFilter::setText(const QString& text) {
  text_ = text.trimmed();
  invalidateFilter();
}

void PairFilter::setObjects(std::vector<int> objects) {
  if (objects == objects_) return;
  objects_ = std::move(objects);
  invalidateFilter();
}

void PairFilter::setClass(std::optional<PairClass> pair_class) {
  if (pair_class == class_) return;
  class_ = pair_class;
  invalidateFilter();
}

void PairFilter::sortAgain() {
  const int column = sortColumn();
  if (column < 0) return;
  const auto before = [&](int a, int b) {
    const QModelIndex first = mapToSource(index(a, column)), second = mapToSource(index(b, column));
    return sortOrder() == Qt::AscendingOrder ? lessThan(first, second) : lessThan(second, first);
  };
  for (int row = 1; row < rowCount(); ++row)
    if (before(row, row - 1)) return sort(column, sortOrder());
}

bool PairFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  const auto& model = *static_cast<const PairTableModel*>(sourceModel());
  const auto [a, b] = model.objectsOf(row);
  const auto chosen = [&](int o) { return std::binary_search(objects_.begin(), objects_.end(), o); };
  if (!objects_.empty() && !chosen(a) && !chosen(b)) return false;
  if (objects_.empty() && class_ && model.classOf(row) != *class_) return false;
  return text_.isEmpty() || model.nameOf(a).contains(text_, Qt::CaseInsensitive) ||
         model.nameOf(b).contains(text_, Qt::CaseInsensitive);
}

}  // namespace abstand::ui
