// Moments that somebody wants to come back to.
#include "ui/model/bookmarks.hpp"

#include <algorithm>

#include "ui/style/format.hpp"

namespace abstand::ui {

void Bookmarks::set(std::vector<Bookmark> bookmarks) {
  std::stable_sort(bookmarks.begin(), bookmarks.end(),
                   [](const Bookmark& a, const Bookmark& b) { return a.t < b.t; });
  if (bookmarks == all_) return;
  beginResetModel();
  all_ = std::move(bookmarks);
  endResetModel();
  Q_EMIT changed();
}

int Bookmarks::add(double t) {
  const auto at = std::lower_bound(all_.begin(), all_.end(), t,
                                   [](const Bookmark& bookmark, double time) { return bookmark.t < time; });
  const int row = static_cast<int>(at - all_.begin());
  if (at != all_.end() && at->t == t) return row;
  beginInsertRows({}, row, row);
  all_.insert(at, {t, {}});
  endInsertRows();
  Q_EMIT changed();
  return row;
}

void Bookmarks::remove(int row) {
  if (row < 0 || row >= rowCount()) return;
  beginRemoveRows({}, row, row);
  all_.erase(all_.begin() + row);
  endRemoveRows();
  Q_EMIT changed();
}

int Bookmarks::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(all_.size());
}

int Bookmarks::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant Bookmarks::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Bookmark& bookmark = all_[static_cast<std::size_t>(index.row())];
  if (role == Qt::DisplayRole || role == Qt::EditRole)
    return index.column() == kTime ? secondsWithUnit(bookmark.t) : bookmark.note;
  return {};
}

QVariant Bookmarks::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == kTime ? tr("Time") : tr("Note");
}

Qt::ItemFlags Bookmarks::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.column() == kNote ? flags | Qt::ItemIsEditable : flags;
}

bool Bookmarks::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != kNote || role != Qt::EditRole) return false;
  all_[static_cast<std::size_t>(index.row())].note = value.toString();
  Q_EMIT dataChanged(index, index);
  Q_EMIT changed();
  return true;
}

}  // namespace abstand::ui
