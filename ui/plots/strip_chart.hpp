// One quantity over time.
#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <vector>

#include "ui/model/frame_series.hpp"

class QLabel;
class QPainter;
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

  /// One line of a chart with several.
  struct Line {
    QString name;
    QColor colour;
    Qt::PenStyle style{Qt::SolidLine};
  };
  /// Instead of the one line of the constructor; their names and values stand above the chart. No line has a
  /// series before setSeries(), as those of the lines before may be gone.
  void setLines(const std::vector<Line>& lines);
  /// The series must outlive the chart or be replaced; null for none. `line`: counts setLines().
  void setSeries(const FrameSeries* series, std::size_t line = 0);
  void setQuantity(const QString& quantity, const QString& unit);
  /// Another unit of the same quantity. A band keeps its height until the next setBand().
  void setUnit(const QString& unit, double factor, int decimals);
  void setWindow(double left, double right);
  void setPlayhead(double t);
  /// Value at the playhead, in the unit of the series, until the playhead moves.
  void setNow(double value, std::size_t line = 0);
  /// NaN: unknown.
  double shownNow(std::size_t line = 0) const;
  /// In the unit of the series; 0 for no band.
  void setBand(double high, const QString& text);
  /// One or more, as setLines() says.
  std::size_t lines() const { return traces_.size(); }
  const FrameSeries* series(std::size_t line) const;
  /// "Distance [mm]"; of a chart with several "Joint torques: gravity [N·m]".
  QString lineName(std::size_t line) const;
  /// From the unit of the series to that of the chart.
  double factor() const { return text_.factor; }
  /// Title, values and plot as they are shown, as lines and letters.
  void paint(QPainter& painter, const QRectF& area);
  /// Draws when something has changed since the last call.
  void refresh();

 Q_SIGNALS:
  void timePicked(double t);
  void windowMoved(double left, double right);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fitValues();
  /// Names and values above the chart; `widest`: with as much room as a value takes.
  QString valuesText(bool widest) const;
  void placeValues();
  void spaceValues(double height);
  long revision() const;
  void applyPalette();
  double timeAt(int x) const;

  Text text_;
  QwtPlot* plot_;
  QLabel *title_, *value_;
  QWidget* values_box_;  // of fixed height, so that new values do not lay out the whole window anew
  QLabel* values_;
  std::vector<Trace*> traces_;  // owned by the plot; at least one
  std::vector<QString> names_;  // of the lines, when there are several
  QwtPlotGrid* grid_;           // owned by the plot
  double left_{0.0}, right_{1.0};
  double low_{0.0}, high_{0.0};
  double drag_from_{0.0};
  bool dirty_{true};
  long shown_revision_{-1};
};

}  // namespace abstand::ui
