// Text and lines over the 3D picture.
#include "ui/viewport/overlay.hpp"

#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr double kAxisLength = 30.0;                                      // px
constexpr double kMargin = 14.0;                                          // px from the edges
constexpr double kAxesRoom = kMargin + 2.0 * (kAxisLength + 6.0) + 10.0;  // px, left of the legend
constexpr int kMarkWidth = 34, kDotWidth = 12;          // px, of the legend's arrows, of its dots
constexpr double kLegendPad = 30.0, kMinLegend = 60.0;  // px, about its marks and texts; of its texts
constexpr double kNameLift = 66.0;  // px from a point up to a name, so that the names do not hide the contact
// px: of labels, from the edge of the view, beside the text, least room for the text
constexpr double kLabelEdge = 4.0, kLabelPad = 16.0, kMinLabel = 60.0;
constexpr double kPointRoom = 9.0;  // px about the ends of a line that no label covers
constexpr double kLineWidth = 2.0, kArrowWidth = 3.5, kArrowHead = 14.0;  // px
constexpr double kValueDrop = 30.0;                                       // px from a point down to a value

constexpr QRgb kAxisColours[3]{0xffa8483c, 0xff4d7f4a, 0xff3f63a0};

/// In the colour of the brush, without an edge.
void arrowHead(QPainter& p, QPointF from, QPointF to, double head) {
  const QPointF d = to - from;
  const double length = std::hypot(d.x(), d.y());
  if (length < 1.0) return;
  const QPointF u = d / length;
  const QPointF side(-u.y(), u.x());
  p.setPen(Qt::NoPen);
  p.drawPolygon(
      QVector<QPointF>{to + u * 2.0, to - u * head + side * head * 0.5, to - u * head - side * head * 0.5});
}

void arrow(QPainter& p, QPointF from, QPointF to, double head) {
  p.drawLine(from, to);
  p.save();
  p.setBrush(p.pen().color());
  arrowHead(p, from, to, head);
  p.restore();
}

/// A value and its unit stay in one line.
QString unitsWithValues(QString text) {
  static const QRegularExpression kAfterDigit(QStringLiteral("(?<=\\d) (?=\\S)"));
  return text.replace(kAfterDigit, QStringLiteral("\u00a0"));
}

QColor edgeColour(OverlayLabel::Style style) {
  switch (style) {
    case OverlayLabel::Style::kContact:
      return QColor(kVermillion);
    case OverlayLabel::Style::kInside:
      return QColor(kOchre);
    case OverlayLabel::Style::kNear:
      return QColor(kAmber);
    case OverlayLabel::Style::kPlain:
      break;
  }
  return QColor(0xff8a95a1);
}

void legendMark(QPainter& p, const LegendLine& line, const QRectF& box) {
  const double y = box.center().y();
  const QPointF left(box.left(), y), right(box.right() - 3, y);
  switch (line.mark) {
    case LegendLine::Mark::kArrow:
      p.setPen(QPen(line.colour, 3.2));
      arrow(p, left, right - QPointF(4, 0), 10.0);
      break;
    case LegendLine::Mark::kThinArrow:
      p.setPen(QPen(line.colour, 1.6));
      arrow(p, left, right - QPointF(2, 0), 7.0);
      break;
    case LegendLine::Mark::kCurvedArrow: {
      const QRectF arc(box.center().x() - 7, y - 7, 14, 14);
      p.setPen(QPen(line.colour, 2.6));
      p.drawArc(arc, 0, 250 * 16);
      const double end = 250.0 * 3.14159265 / 180.0;
      const QPointF tip(arc.center().x() + 7 * std::cos(end), arc.center().y() - 7 * std::sin(end));
      arrow(p, tip - QPointF(0.2, 0), tip + QPointF(1.2, 0.5), 8.0);
      break;
    }
    case LegendLine::Mark::kDot:
      p.setPen(QPen(p.pen().color(), 0.6));  // that of the text: dots may have the colour of the legend
      p.setBrush(line.colour);
      p.drawEllipse(QPointF(box.center().x(), y), 3.5, 3.5);
      p.setBrush(Qt::NoBrush);
      break;
    case LegendLine::Mark::kDashes:
      p.setPen(QPen(line.colour, 2.0, Qt::DashLine));
      p.drawLine(left, right);
      break;
  }
}

}  // namespace

Overlay::Overlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
}

void Overlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!content_.message.isEmpty()) {
    paintMessage(painter);
    return;
  }
  for (const OverlaySegment& segment : content_.segments) {
    // A light rim keeps the line apart from bodies of any colour.
    const double width = segment.arrow ? kArrowWidth : kLineWidth;
    painter.setPen(QPen(QColor(255, 255, 255, 170), width + 2.0, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(segment.a, segment.b);
    painter.setPen(QPen(segment.colour, width, segment.dashed ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(segment.a, segment.b);
    painter.setPen(QPen(Qt::white, 1.2));
    painter.setBrush(segment.colour);
    painter.drawEllipse(segment.a, 4.0, 4.0);
    if (segment.arrow)
      arrowHead(painter, segment.a, segment.b, kArrowHead);
    else
      painter.drawEllipse(segment.b, 4.0, 4.0);
  }
  paintHandles(painter);
  paintLabels(painter);
  paintAxes(painter);
  paintLegend(painter);
}

QFont Overlay::labelFont() const {
  QFont font = this->font();
  font.setWeight(QFont::DemiBold);
  return font;
}

std::vector<PlacedLabel> Overlay::placeLabels() const {
  // Labels keep off the ends of the lines, where that is which they speak of, and off the tips of handles.
  std::vector<QRectF> taken;
  for (const OverlaySegment& segment : content_.segments)
    for (const QPointF& end : {segment.a, segment.b})
      taken.emplace_back(end - QPointF(kPointRoom, kPointRoom), end + QPointF(kPointRoom, kPointRoom));
  if (content_.handles)
    for (const QPointF& tip : content_.handles->tips)
      taken.push_back(QRectF(0.5 * (content_.handles->centre + tip), tip)
                          .normalized()
                          .adjusted(-kPointRoom, -kPointRoom, kPointRoom, kPointRoom));
  const QFontMetricsF metrics(labelFont(), const_cast<Overlay*>(this));
  // Lower points first, so that the lines up to the labels cross each other less.
  std::vector<PlacedLabel> placed;
  std::vector<const OverlayLabel*> order;
  for (const OverlayLabel& label : content_.labels) order.push_back(&label);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->at.y() > b->at.y(); });
  for (const OverlayLabel* each : order) {
    OverlayLabel label = *each;
    label.text = unitsWithValues(label.text);
    if (!rect().adjusted(-20, -20, 20, 20).contains(label.at.toPoint())) continue;
    // Wrapped if it is longer than the view is wide.
    const QRectF room(0.0, 0.0, std::max(kMinLabel, width() - 2.0 * kLabelEdge - kLabelPad), 1e4);
    const QRectF text = metrics.boundingRect(room, Qt::TextWordWrap, label.text);
    QRectF box(0, 0, std::ceil(text.width()) + kLabelPad, std::ceil(text.height()) + 6);
    box.moveCenter(label.at + QPointF(0, label.below ? kValueDrop : -kNameLift));
    const auto overlaps = [&](const QRectF& other) { return other.adjusted(-2, -2, 2, 2).intersects(box); };
    box.moveLeft(
        std::clamp(box.left(), kLabelEdge, std::max(kLabelEdge, width() - box.width() - kLabelEdge)));
    // Away from what is there already; from the edge on in the other direction.
    double step = (label.below ? 1.0 : -1.0) * (box.height() + 3);
    for (int tries = 0; tries < 16; ++tries) {
      if (box.top() < kLabelEdge || box.bottom() > height() - kLabelEdge) {
        box.moveTop(box.top() < kLabelEdge ? kLabelEdge : height() - box.height() - kLabelEdge);
        step = box.top() < 0.5 * height() ? std::abs(step) : -std::abs(step);
      }
      if (std::none_of(taken.begin(), taken.end(), overlaps)) break;
      box.translate(0, step);
    }
    taken.push_back(box);
    placed.push_back({label, box});
  }
  return placed;
}

void Overlay::paintLabels(QPainter& painter) const {
  const SceneColours colours = sceneColours(themeOf(palette()));
  painter.setFont(labelFont());
  const std::vector<PlacedLabel> placed = placeLabels();
  // All lines below all labels.
  for (const auto& [label, box] : placed) {
    painter.setPen(QPen(edgeColour(label.style), 1.2));
    painter.drawLine(label.at, QPointF(std::clamp(label.at.x(), box.left(), box.right()),
                                       box.center().y() > label.at.y() ? box.top() : box.bottom()));
  }
  for (const auto& [label, box] : placed) {
    const bool contact = label.style == OverlayLabel::Style::kContact;
    const QColor edge = edgeColour(label.style);
    painter.setPen(QPen(edge, 1.2));
    painter.setBrush(contact ? edge : colours.label_back);
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(contact ? QColor(Qt::white) : colours.label_text);
    painter.drawText(box.adjusted(0.5 * kLabelPad - 1.0, 0.0, 1.0 - 0.5 * kLabelPad, 0.0),
                     Qt::AlignCenter | Qt::TextWordWrap, label.text);
  }
}

/// In the colours of the axes; the held one is thicker.
void Overlay::paintHandles(QPainter& painter) const {
  if (!content_.handles) return;
  const Handles::Drawing& shown = *content_.handles;
  const auto pen = [&](const QColor& colour, bool held, bool rim) {
    const double width = (held ? kArrowWidth + 1.5 : kArrowWidth) + (rim ? 2.5 : 0.0);
    return QPen(rim ? QColor(255, 255, 255, 190) : colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  };
  const QPolygonF ring(QVector<QPointF>(shown.ring.begin(), shown.ring.end()));
  const QColor ring_colour(kAxisColours[2]);
  painter.setBrush(Qt::NoBrush);
  for (const bool rim : {true, false}) {
    painter.setPen(pen(ring_colour, shown.held == Handles::Part::kTurn, rim));
    painter.drawPolyline(ring);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const bool held = shown.held == static_cast<Handles::Part>(k);
    painter.setPen(pen(QColor(kAxisColours[k]), held, true));
    painter.drawLine(shown.centre, shown.tips[k]);
    painter.setPen(pen(QColor(kAxisColours[k]), held, false));
    arrow(painter, shown.centre, shown.tips[k], kArrowHead);
  }
}

void Overlay::paintAxes(QPainter& painter) const {
  const int lighter = themeOf(palette()) == Theme::kDark ? 150 : 100;
  static const QString kNames[3]{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  const QPointF origin(kMargin + kAxisLength + 6, height() - kMargin - kAxisLength - 6);
  QFont font = this->font();
  font.setBold(true);
  painter.setFont(font);
  for (int k = 0; k < 3; ++k) {
    const QPointF d = content_.axes[static_cast<std::size_t>(k)];
    const QPointF tip = origin + kAxisLength * d;
    painter.setPen(QPen(QColor(kAxisColours[k]).lighter(lighter), 2.2, Qt::SolidLine, Qt::RoundCap));
    arrow(painter, origin, tip, 7.0);
    if (std::hypot(d.x(), d.y()) < 0.15) continue;
    const QPointF at = tip + 9.0 * d / std::hypot(d.x(), d.y());
    painter.drawText(QRectF(at.x() - 8, at.y() - 9, 16, 18), Qt::AlignCenter, kNames[k]);
  }
}

LegendPlace Overlay::placeLegend() const {
  const QFontMetricsF metrics(font(), const_cast<Overlay*>(this));
  // Lines that are longer than the view beside the axes is wide are wrapped.
  LegendPlace place;
  place.mark_width =
      std::ranges::all_of(content_.legend,
                          [](const LegendLine& line) { return line.mark == LegendLine::Mark::kDot; })
          ? kDotWidth
          : kMarkWidth;
  const double room = std::max(kMinLegend, width() - kAxesRoom - kMargin - place.mark_width - kLegendPad);
  const QRectF line_room(0.0, 0.0, room, 1e4);
  double text_width = 0.0, height = 0.0;
  for (const LegendLine& line : content_.legend) {
    const QRectF text = metrics.boundingRect(line_room, Qt::TextWordWrap, line.text);
    text_width = std::max(text_width, std::ceil(text.width()) + 1.0);
    place.rows.push_back(std::ceil(text.height()) + 5.0);
    height += place.rows.back();
  }
  place.box = QRectF(0, 0, text_width + place.mark_width + kLegendPad, height + 10.0);
  place.box.moveBottomRight(QPointF(width() - kMargin, this->height() - kMargin));
  return place;
}

void Overlay::paintLegend(QPainter& painter) const {
  if (content_.legend.empty()) return;
  const SceneColours colours = sceneColours(themeOf(palette()));
  painter.setFont(font());
  const auto [box, rows, mark_width] = placeLegend();
  QColor back = colours.label_back;
  back.setAlpha(200);
  painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
  painter.setBrush(back);
  painter.drawRoundedRect(box, 5.0, 5.0);
  double y = box.top() + 5.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const LegendLine& line = content_.legend[i];
    painter.setBrush(Qt::NoBrush);
    painter.setPen(colours.label_text);
    legendMark(painter, line, QRectF(box.left() + 10, y, mark_width, rows[i]));
    painter.setPen(colours.label_text);
    painter.drawText(QRectF(box.left() + mark_width + 20, y, box.width() - mark_width - kLegendPad, rows[i]),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, line.text);
    y += rows[i];
  }
}

void Overlay::paintMessage(QPainter& painter) const {
  const SceneColours colours = sceneColours(themeOf(palette()));
  QFont font = this->font();
  font.setPointSizeF(font.pointSizeF() + 2.0);
  painter.setFont(font);
  const QRect area = rect().adjusted(40, 40, -40, -40);
  QRectF box = painter.boundingRect(area, Qt::AlignCenter | Qt::TextWordWrap, content_.message);
  box.adjust(-24, -18, 24, 18);
  QColor back = colours.label_back;
  painter.setBrush(back);
  painter.setPen(QPen(palette().color(QPalette::Mid), 1.0));
  painter.drawRoundedRect(box, 8.0, 8.0);
  painter.setPen(colours.label_text);
  painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap, content_.message);
}

}  // namespace abstand::ui
