// Margin of a class of pairs: a tick, and slider and spin box for the margin.
#pragma once

#include <QWidget>
#include <optional>

class QCheckBox;

namespace abstand::ui {

class MarginRow;

/// Without the tick the margins of the class are sums, of which the largest is shown; nothing can be moved
/// then. GUI thread only.
class ClassMarginRow : public QWidget {
  Q_OBJECT

 public:
  explicit ClassMarginRow(const QString& name, QWidget* parent = nullptr);

  /// m; nullopt: no margin of its own. Without a signal.
  void show(const std::optional<double>& metres, bool locked);
  /// m, shown where the class has no margin of its own.
  void showSum(double metres);
  bool isTicked() const;
  /// The user holds the slider.
  bool isDragged() const;
  /// px; so that the sliders of several rows begin below each other.
  int nameWidth() const;
  void setNameWidth(int width);
  QCheckBox* tick() const { return tick_; }
  MarginRow* row() const { return row_; }

 Q_SIGNALS:
  void tickWanted(bool on);
  void lockWanted(bool locked);
  /// m: the user moved it.
  void edited(double metres);
  /// The user let go of the slider.
  void released();

 private:
  QCheckBox* tick_;
  MarginRow* row_;
};

}  // namespace abstand::ui
