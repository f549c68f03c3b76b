// The checked pairs with their latest results.
#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <functional>
#include <optional>
#include <vector>

#include "ui/model/pair_class.hpp"
#include "ui/model/pair_level.hpp"

namespace abstand::ui {

/// One row a pair, in scene order, all rows from open() on; refresh() only changes values, so views keep
/// selection and scroll position. It announces nothing: announce() those rows that can be seen. GUI thread
/// only.
class PairTableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kState, kA, kB, kDistance, kUncertainty, kMargin, kForce, kPoints, kColumns };
  /// Number to sort by; NaN as infinity.
  static constexpr int kSortRole = Qt::UserRole;

  explicit PairTableModel(QObject* parent = nullptr);

  void open(const view::SceneOutline& outline);
  void refresh(const view::SceneSnapshot& snapshot);
  /// What the tool tip says of a pair; asked for while the pointer rests over it.
  void setSentence(std::function<QString(int pair)> sentence) { sentence_ = std::move(sentence); }
  /// The values of this row have changed.
  void announce(int row);
  /// SceneSnapshot::step of the last refresh.
  long shownStep() const { return shown_step_; }

  PairClass classOf(int pair) const { return classes_[static_cast<std::size_t>(pair)]; }
  std::pair<int, int> objectsOf(int pair) const { return pairs_[static_cast<std::size_t>(pair)]; }
  QString nameOf(int object) const { return names_[static_cast<std::size_t>(object)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Pairs, for the plots.
  QMimeData* mimeData(const QModelIndexList& indexes) const override;

 private:
  QVariant text(std::size_t row, int column) const;
  double number(std::size_t row, int column) const;

  std::vector<QString> names_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<PairClass> classes_;  // by pair
  std::vector<view::PairSnapshot> values_;
  std::vector<PairLevel> levels_;  // by pair
  std::function<QString(int)> sentence_;
  long shown_step_{-1};
  std::vector<double> uncertainty_;  // by pair, m: of both poses
};

/// Sorted by any column and narrowed to a text in either name, and to the pairs of the chosen objects, or,
/// without such, to a class. Rows whose values change keep their places until sortAgain().
class PairFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit PairFilter(QObject* parent = nullptr);
  void setText(const QString& text);
  /// Sorted object indices; empty: all pairs.
  void setObjects(std::vector<int> objects);
  /// None: all classes.
  void setClass(std::optional<PairClass> pair_class);
  /// Sorts where the rows are out of order.
  void sortAgain();

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  QString text_;
  std::vector<int> objects_;
  std::optional<PairClass> class_;
};

}  // namespace abstand::ui
