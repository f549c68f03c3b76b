#include "ui/panels/body_view.hpp"

#include <QPainter>

#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr double kBodyHeight = 2.1, kBodyWidth = 1.2;  // m, of each view
constexpr int kFiguresHeight = 150, kMinFigures = 80;  // px

QString described(const QString& who, const BodyShape& shape) {
  return BodyView::tr("%1: %2 m, %3 kg").arg(who, fixed(shape.stature, 2), fixed(shape.mass, 0));
}

}  // namespace

BodyView::BodyView(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
  setObjectName(QStringLiteral("body_view"));
}

QSize BodyView::sizeHint() const { return {260, kFiguresHeight + 3 * fontMetrics().lineSpacing()}; }
// Where the panel is low, the figures give way to the properties.
QSize BodyView::minimumSizeHint() const { return {200, 3 * fontMetrics().lineSpacing()}; }

int BodyView::figuresHeight() const {
  const int left = height() - 3 * fontMetrics().lineSpacing();
  return left < kMinFigures ? 0 : left;
}

void BodyView::show(const BodyPreview& preview) {
  preview_ = preview;
  setAccessibleName(text());
  setToolTip(text());
  update();
}

QString BodyView::text() const {
  if (!preview_.problem.isEmpty()) return preview_.problem;
  return described(tr("This person"), preview_.person) + QLatin1Char('\n') +
         described(tr("Woman, 5th percentile"), preview_.smallest) + QLatin1Char('\n') +
         described(tr("Man, 95th percentile"), preview_.largest);
}

QPainterPath BodyView::outline(const BodyShape& shape, int across) {
  QPainterPath path;
  for (const BodyPatch& patch : shape.patches) {
    QPainterPath part;
    const QRectF box(patch.centre[across] - patch.half[across], patch.centre.z() - patch.half.z(),
                     2.0 * patch.half[across], 2.0 * patch.half.z());
    if (patch.box)
      part.addRect(box);
    else
      part.addEllipse(box);
    path = path.united(part);
  }
  return path;
}

void BodyView::paintFigures(QPainter& painter, const QRectF& place, int across) const {
  const double scale = std::min(place.height() / kBodyHeight, place.width() / kBodyWidth);
  QTransform to_screen;
  to_screen.translate(place.center().x(), place.bottom());
  // From the front, the person's left is on the right.
  to_screen.scale(scale, -scale);
  const auto draw = [&](const BodyShape& shape, const QPen& pen, const QBrush& brush) {
    painter.setPen(pen);
    painter.setBrush(brush);
    painter.drawPath(to_screen.map(outline(shape, across)));
  };
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawLine(place.bottomLeft(), place.bottomRight());
  QColor fill(kAccent);
  fill.setAlpha(110);
  draw(preview_.person, QPen(QColor(kAccent), 1.2), fill);
  const QColor ink = palette().color(QPalette::WindowText);
  draw(preview_.smallest, QPen(ink, 1.0, Qt::SolidLine), Qt::NoBrush);
  draw(preview_.largest, QPen(ink, 1.0, Qt::DashLine), Qt::NoBrush);
}

void BodyView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!preview_.problem.isEmpty()) {
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(4, 0, -4, 0), Qt::AlignCenter | Qt::TextWordWrap, preview_.problem);
    return;
  }
  const double half = 0.5 * width();
  const int figures = figuresHeight();
  if (figures > 0) {
    paintFigures(painter, QRectF(4, 4, half - 8, figures - 8), 1);
    paintFigures(painter, QRectF(half + 4, 4, half - 8, figures - 8), 0);
  }
  // A legend of three lines, each with a sample of its line.
  const QColor ink = palette().color(QPalette::WindowText);
  const QPen pens[] = {QPen(QColor(kAccent), 5.0), QPen(ink, 1.0), QPen(ink, 1.0, Qt::DashLine)};
  const QStringList lines = text().split(QLatin1Char('\n'));
  const int spacing = fontMetrics().lineSpacing();
  for (int i = 0; i < lines.size(); ++i) {
    const int y = figures + i * spacing + spacing / 2;
    painter.setPen(pens[i]);
    painter.drawLine(8, y, 30, y);
    painter.setPen(ink);
    painter.drawText(QRect(38, y - spacing / 2, width() - 42, spacing), Qt::AlignVCenter, lines[i]);
  }
}

}  // namespace abstand::ui
