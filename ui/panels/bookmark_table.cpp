#include "ui/panels/bookmark_table.hpp"

#include "ui/style/format.hpp"

namespace abstand::ui {

void BookmarkTable::show(const QVector<Bookmark>& bookmarks) {
  if (bookmarks == all_) return;
  beginResetModel();
  all_ = bookmarks;
  endResetModel();
}

int BookmarkTable::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : all_.size(); }

int BookmarkTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant BookmarkTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Bookmark& bookmark = all_[index.row()];
  if (role == Qt::DisplayRole || role == Qt::EditRole)
    return index.column() == kTime ? secondsWithUnit(bookmark.t) : bookmark.note;
  return {};
}

QVariant BookmarkTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == kTime ? tr("Time") : tr("Note");
}

Qt::ItemFlags BookmarkTable::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.column() == kNote ? flags | Qt::ItemIsEditable : flags;
}

bool BookmarkTable::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (!index.isValid() || index.column() != kNote || role != Qt::EditRole) return false;
  Q_EMIT noteWanted(index.row(), value.toString().simplified());
  return true;
}

}  // namespace abstand::ui
