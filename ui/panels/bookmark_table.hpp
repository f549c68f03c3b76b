// The document's bookmarks as a table.
#pragma once

#include <QAbstractTableModel>
#include <QVector>

#include "ui/document/work.hpp"

namespace abstand::ui {

/// A row for each bookmark with its time and its note. Shows what it is given: an edited note is only
/// requested, and comes back by show(). GUI thread only.
class BookmarkTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kTime, kNote, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  const QVector<Bookmark>& all() const { return all_; }
  /// In order of time.
  void show(const QVector<Bookmark>& bookmarks);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void noteWanted(int row, const QString& note);

 private:
  QVector<Bookmark> all_;
};

}  // namespace abstand::ui
