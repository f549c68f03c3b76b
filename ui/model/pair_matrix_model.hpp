// Bodies against bodies: which pairs are checked, how near they are, and why others are not checked.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/model/pair_level.hpp"

namespace abstand::ui {

/// Rows are body parts and columns links of robots; without people or without robots, all bodies are both. A
/// ticked cell is a pair that is checked. GUI thread only.
class PairMatrixModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  /// `all`: all bodies are rows and columns.
  void open(const view::SceneOutline& outline, bool all);
  /// Values of one moment; the view is told by announce().
  void refresh(const view::SceneSnapshot& snapshot);
  /// All cells may look different.
  void announce();

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

  int bodyOfRow(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  int bodyOfColumn(int column) const { return columns_[static_cast<std::size_t>(column)]; }
  /// Index into SceneOutline::pairs, -1: no pair.
  int pairAt(const QModelIndex& index) const { return cellAt(index).pair; }

 Q_SIGNALS:
  /// By the user. Two bodies that are no pair may be asked for as well.
  void checkWanted(int a, int b, bool checked);

 private:
  struct Cell {
    int pair{-1};       ///< index into SceneOutline::pairs
    int unchecked{-1};  ///< index into SceneOutline::unchecked
  };
  Cell cellAt(const QModelIndex& index) const;
  bool isChecked(const Cell& cell) const;
  QString tip(const QModelIndex& index) const;
  QString nameOf(int object) const;

  view::SceneOutline outline_;  ///< names and pairs only
  std::vector<int> rows_, columns_;
  std::vector<Cell> cells_;  ///< of all bodies, by a * n + b with a < b
  std::vector<double> distances_;
  std::vector<PairLevel> levels_;
};

}  // namespace abstand::ui
