#include "ui/model/pair_matrix_model.hpp"

#include <QBrush>
#include <QColor>
#include <algorithm>
#include <cmath>

#include "ui/model/groups.hpp"
#include "ui/model/inspected_pairs.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

enum class MatrixSide { kPerson, kRobot, kThing };

MatrixSide matrixSideOf(const view::SceneOutline::ObjectInfo& info) {
  if (info.human) return MatrixSide::kPerson;
  return info.group == "objects" ? MatrixSide::kThing : MatrixSide::kRobot;
}

QBrush brushOf(PairLevel level) {
  const bool broken = isBroken(level);
  if (!broken && level != PairLevel::kNear && level != PairLevel::kLost) return {};
  QColor tint = levelColour(level);
  tint.setAlpha(broken ? 90 : 60);
  return tint;
}

}  // namespace

void PairMatrixModel::open(const view::SceneOutline& outline, bool all) {
  beginResetModel();
  outline_.objects = outline.objects;
  outline_.pairs = outline.pairs;
  outline_.unchecked = outline.unchecked;
  outline_.unchecked_notes = outline.unchecked_notes;
  rows_.clear();
  columns_.clear();
  const std::size_t n = outline.objects.size();
  for (std::size_t i = 0; i < n && !all; ++i) {
    const MatrixSide side = matrixSideOf(outline.objects[i]);
    if (side == MatrixSide::kPerson) rows_.push_back(static_cast<int>(i));
    if (side == MatrixSide::kRobot) columns_.push_back(static_cast<int>(i));
  }
  if (rows_.empty() || columns_.empty()) {
    rows_.resize(n);
    for (std::size_t i = 0; i < n; ++i) rows_[i] = static_cast<int>(i);
    columns_ = rows_;
  }
  cells_.assign(n * n, {});
  const auto cell = [&](int a, int b) -> Cell& {
    return cells_[static_cast<std::size_t>(std::min(a, b)) * n + static_cast<std::size_t>(std::max(a, b))];
  };
  for (std::size_t p = 0; p < outline.pairs.size(); ++p)
    cell(outline.pairs[p].first, outline.pairs[p].second).pair = static_cast<int>(p);
  for (std::size_t u = 0; u < outline.unchecked.size(); ++u)
    cell(outline.unchecked[u].a, outline.unchecked[u].b).unchecked = static_cast<int>(u);
  distances_.assign(outline.pairs.size(), kNaN);
  levels_.assign(outline.pairs.size(), PairLevel::kUnknown);
  endResetModel();
}

void PairMatrixModel::refresh(const view::SceneSnapshot& snapshot) {
  if (snapshot.pairs.size() != distances_.size() || snapshot.objects.size() != outline_.objects.size())
    return;
  for (std::size_t p = 0; p < distances_.size(); ++p) {
    distances_[p] = snapshot.pairs[p].result.distance;
    levels_[p] = pairLevel(snapshot, snapshot.pairs[p], outline_.pairs[p]);
  }
}

void PairMatrixModel::announce() {
  if (rowCount() > 0 && columnCount() > 0)
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int PairMatrixModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int PairMatrixModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

PairMatrixModel::Cell PairMatrixModel::cellAt(const QModelIndex& index) const {
  const auto a = static_cast<std::size_t>(bodyOfRow(index.row()));
  const auto b = static_cast<std::size_t>(bodyOfColumn(index.column()));
  return cells_[std::min(a, b) * outline_.objects.size() + std::max(a, b)];
}

bool PairMatrixModel::isChecked(const Cell& cell) const {
  return cell.pair >= 0 && levels_[static_cast<std::size_t>(cell.pair)] != PairLevel::kPaused;
}

QString PairMatrixModel::nameOf(int object) const {
  return QString::fromStdString(outline_.objects[static_cast<std::size_t>(object)].name);
}

QString PairMatrixModel::tip(const QModelIndex& index) const {
  const Cell cell = cellAt(index);
  const QString names =
      tr("%1 – %2").arg(nameOf(bodyOfRow(index.row())), nameOf(bodyOfColumn(index.column())));
  if (cell.pair >= 0) {
    const auto p = static_cast<std::size_t>(cell.pair);
    if (levels_[p] == PairLevel::kPaused)
      return tr("%1: not checked now, its group does not run or it is in none").arg(names);
    return tr("%1: %2, %3").arg(names, levelText(levels_[p]), lengthText(distances_[p]));
  }
  if (cell.unchecked < 0) return names;
  const view::UncheckedPair& pair = outline_.unchecked[static_cast<std::size_t>(cell.unchecked)];
  QString reason = uncheckedReasonText(pair.reason);
  if (pair.note >= 0)
    reason += QStringLiteral(": ") +
              QString::fromStdString(outline_.unchecked_notes[static_cast<std::size_t>(pair.note)]);
  return tr("%1: never checked, %2").arg(names, reason);
}

QVariant PairMatrixModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (bodyOfRow(index.row()) == bodyOfColumn(index.column()))
    return role == Qt::BackgroundRole ? QVariant(QBrush(Qt::darkGray)) : QVariant();
  const Cell cell = cellAt(index);
  const auto p = static_cast<std::size_t>(std::max(0, cell.pair));
  switch (role) {
    case Qt::DisplayRole:
      return isChecked(cell) ? lengthNumber(distances_[p], 0) : QString();
    case Qt::CheckStateRole:
      return isChecked(cell) ? Qt::Checked : Qt::Unchecked;
    case Qt::ToolTipRole:
      return tip(index);
    case Qt::TextAlignmentRole:
      return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::BackgroundRole:
      if (isChecked(cell)) return brushOf(levels_[p]);
      return QBrush(QColor(cell.pair >= 0 ? kAmber : 0xff8a95a1), Qt::BDiagPattern);
    default:
      return {};
  }
}

bool PairMatrixModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || !index.isValid()) return false;
  const auto [a, b] = std::minmax({bodyOfRow(index.row()), bodyOfColumn(index.column())});
  // The cell shows it once the session does so.
  Q_EMIT checkWanted(a, b, value.toInt() == Qt::Checked);
  return false;
}

QVariant PairMatrixModel::headerData(int section, Qt::Orientation orientation, int role) const {
  const auto& bodies = orientation == Qt::Horizontal ? columns_ : rows_;
  if (section < 0 || static_cast<std::size_t>(section) >= bodies.size()) return {};
  const int object = bodies[static_cast<std::size_t>(section)];
  const auto& info = outline_.objects[static_cast<std::size_t>(object)];
  if (role == Qt::ToolTipRole) return nameOf(object);
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical)
    return QString::fromStdString(clearName(outline_, static_cast<std::size_t>(object)));
  const QString name = QString::fromStdString(shortName(info));
  return info.group == "objects" ? name : QString::fromStdString(info.group) + QLatin1Char('\n') + name;
}

Qt::ItemFlags PairMatrixModel::flags(const QModelIndex& index) const {
  if (!index.isValid() || bodyOfRow(index.row()) == bodyOfColumn(index.column())) return Qt::NoItemFlags;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable;
}

}  // namespace abstand::ui
