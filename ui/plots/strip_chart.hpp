// One quantity over time.
#pragma once

#include <QString>
#include <QWidget>
#include <memory>

#include "ui/model/frame_series.hpp"

class QLabel;
class QwtPlot;
class QwtPlotGrid;

namespace abstand::ui {

class Trace;

/// A chart of one FrameSeries with axis titles, grid, playhead and an optional margin band. The value axis
/// fits what the window shows. Left button: scrub; wheel: zoom about the pointer; other buttons: drag the
/// window.
class StripChart : public QWidget {
  Q_OBJECT

 public:
  struct Text {
    QString quantity;    ///< "Distance"
    QString unit;        ///< "mm"
    double factor{1.0};  ///< from the series's unit to `unit`
    int decimals{1};
    bool time_axis{false};  ///< with labels and title below
  };

  StripChart(Text text, const QColor& colour, QWidget* parent = nullptr);
  ~StripChart() override;

  /// The series must outlive the chart or be replaced; null for none.
  void setSeries(const FrameSeries* series);
  void setWindow(double left, double right);
  void setPlayhead(double t);
  /// In the unit of the series; 0 for no band.
  void setBand(double high, const QString& text);
  /// Draws when something has changed since the last call.
  void refresh();

 Q_SIGNALS:
  void timePicked(double t);
  void windowMoved(double left, double right);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fitValues();
  void applyPalette();
  double timeAt(int x) const;

  Text text_;
  QwtPlot* plot_;
  QLabel* value_;
  Trace* trace_;       // owned by the plot
  QwtPlotGrid* grid_;  // owned by the plot
  double left_{0.0}, right_{1.0};
  double low_{0.0}, high_{0.0};
  double drag_from_{0.0};
  bool dirty_{true};
  long shown_revision_{-1};
};

}  // namespace abstand::ui
