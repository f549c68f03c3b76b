// Text and lines over the 3D picture, drawn by Qt: sharp at any scale, never hidden behind a body.
#pragma once

#include <QColor>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "ui/viewport/handles.hpp"

namespace abstand::ui {

struct OverlayLabel {
  enum class Style { kContact, kInside, kNear, kPlain };
  QPointF at;
  QString text;
  Style style{Style::kPlain};
  bool below{false};  ///< the label stands below its point, else well above it
};

struct PlacedLabel {
  OverlayLabel label;
  QRectF box;
};

struct OverlaySegment {
  QPointF a, b;
  QColor colour;
  bool dashed{false};
  bool arrow{false};  ///< with a head at b, and thicker
};

struct LegendLine {
  enum class Mark { kArrow, kCurvedArrow, kThinArrow, kDashes, kDot };
  Mark mark{Mark::kArrow};
  QColor colour;
  QString text;
};

/// Where the legend stands, and the heights of its lines (px).
struct LegendPlace {
  QRectF box;
  std::vector<double> rows;  ///< px, heights of the lines
  double mark_width;         ///< px
};

struct OverlayContent {
  std::vector<OverlayLabel> labels;
  std::vector<OverlaySegment> segments;
  std::vector<LegendLine> legend;
  std::array<QPointF, 3> axes;  ///< x, y, z on the screen, length at most 1
  std::optional<Handles::Drawing> handles;
  QString message;    ///< in the middle of an empty view
  QString reset_key;  ///< that resets stopped robots, for their labels; empty: none
};

/// Lets all mouse events through.
class Overlay : public QWidget {
 public:
  explicit Overlay(QWidget* parent);
  OverlayContent& content() { return content_; }
  const OverlayContent& content() const { return content_; }
  /// Where the labels stand, each as near to its point as others and the ends of lines allow.
  std::vector<PlacedLabel> placeLabels() const;
  /// In the lower right corner, within the view.
  LegendPlace placeLegend() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QFont labelFont() const;
  void paintAxes(QPainter& painter) const;
  void paintHandles(QPainter& painter) const;
  void paintLegend(QPainter& painter) const;
  void paintLabels(QPainter& painter) const;
  void paintMessage(QPainter& painter) const;

  OverlayContent content_;
};

}  // namespace abstand::ui
