// Moments that somebody wants to come back to.
#pragma once

#include <QAbstractTableModel>
#include <vector>

namespace abstand::ui {

struct Bookmark {
  double t{0.0};  ///< s of the recording
  QString note;

  bool operator==(const Bookmark&) const = default;
};

/// A table of a time and a note, in order of time; notes can be edited. GUI thread only.
class Bookmarks : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kTime, kNote, kColumns };

  using QAbstractTableModel::QAbstractTableModel;

  const std::vector<Bookmark>& all() const { return all_; }
  void set(std::vector<Bookmark> bookmarks);
  /// Returns its row; a moment that has a bookmark gets no second one.
  int add(double t);
  void remove(int row);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void changed();

 private:
  std::vector<Bookmark> all_;
};

}  // namespace abstand::ui
