// Terms of the protective distance as stacked bars against the measured distance, a row for each body part.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/model/separation_rows.hpp"

namespace abstand::ui {

/// GUI thread only.
class SeparationChart : public QWidget {
  Q_OBJECT

 public:
  static constexpr int kRowHeight = 22;  ///< px

  explicit SeparationChart(QWidget* parent = nullptr);

  /// The outline must outlive its stay here.
  void open(const view::SceneOutline& outline);
  void show(const std::vector<SeparationRow>& rows, const SeparationSettings& settings);
  const std::vector<SeparationRow>& rows() const { return rows_; }
  int rowAt(int y) const;
  QSize sizeHint() const override;

 Q_SIGNALS:
  /// Of the outline.
  void pairPicked(int pair);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRect bars(int row) const;
  void paintLegend(QPainter& painter) const;
  void paintRow(QPainter& painter, int row, double scale) const;
  void paintContact(QPainter& painter, const SeparationRow& row, const QRect& place) const;

  const view::SceneOutline* outline_{nullptr};
  SeparationSettings settings_;
  std::vector<SeparationRow> rows_;
};

}  // namespace abstand::ui
