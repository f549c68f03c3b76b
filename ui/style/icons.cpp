// Vector icons, drawn on a grid of 24 units.
#include "ui/style/icons.hpp"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

void triangle(QPainter& p, QPointF a, QPointF b, QPointF c) {
  p.setBrush(p.pen().color());
  p.drawPolygon(QVector<QPointF>{a, b, c});
  p.setBrush(Qt::NoBrush);
}

void bar(QPainter& p, double x) { p.fillRect(QRectF(x, 5, 2.6, 14), p.pen().color()); }

void cube(QPainter& p, int face) {
  // The three visible faces: top, front (left), side (right).
  const QPolygonF top(QVector<QPointF>{{12, 3}, {20, 7.5}, {12, 12}, {4, 7.5}});
  const QPolygonF front(QVector<QPointF>{{4, 7.5}, {12, 12}, {12, 21}, {4, 16.5}});
  const QPolygonF side(QVector<QPointF>{{20, 7.5}, {12, 12}, {12, 21}, {20, 16.5}});
  const QPolygonF* faces[] = {&top, &front, &side};
  for (int i = 0; i < 3; ++i) {
    p.setBrush(i == face ? QBrush(p.pen().color()) : QBrush(Qt::NoBrush));
    p.drawPolygon(*faces[i]);
  }
}

void arrowHead(QPainter& p, QPointF tip, QPointF direction, double size) {
  const QPointF side(-direction.y(), direction.x());
  triangle(p, tip, tip - direction * size + side * size * 0.5, tip - direction * size - side * size * 0.5);
}

void transport(QPainter& p, Glyph glyph) {
  switch (glyph) {
    case Glyph::kPlay:
      triangle(p, {7, 4.5}, {19, 12}, {7, 19.5});
      break;
    case Glyph::kPause:
      p.fillRect(QRectF(6.5, 5, 4, 14), p.pen().color()), p.fillRect(QRectF(13.5, 5, 4, 14), p.pen().color());
      break;
    case Glyph::kStepForward:
      bar(p, 6), triangle(p, {11, 6}, {19, 12}, {11, 18});
      break;
    case Glyph::kStepBack:
      bar(p, 15.5), triangle(p, {13, 6}, {5, 12}, {13, 18});
      break;
    case Glyph::kForwardSecond:
      triangle(p, {4, 6}, {12, 12}, {4, 18}), triangle(p, {12, 6}, {20, 12}, {12, 18});
      break;
    case Glyph::kBackSecond:
      triangle(p, {20, 6}, {12, 12}, {20, 18}), triangle(p, {12, 6}, {4, 12}, {12, 18});
      break;
    case Glyph::kToStart:
      bar(p, 5), triangle(p, {18, 6}, {9, 12}, {18, 18});
      break;
    case Glyph::kToEnd:
      bar(p, 16.5), triangle(p, {6, 6}, {15, 12}, {6, 18});
      break;
    default:
      p.drawArc(QRectF(5, 5, 14, 14), 30 * 16, 290 * 16);
      arrowHead(p, {19.6, 12.2}, {0.35, 0.94}, 6);
  }
}

void showing(QPainter& p, Glyph glyph) {
  switch (glyph) {
    case Glyph::kForce:
      p.drawLine(QPointF(5, 19), QPointF(15, 9)), arrowHead(p, {20, 4}, {0.707, -0.707}, 8);
      break;
    case Glyph::kTorque:
      p.drawArc(QRectF(4.5, 5.5, 15, 15), -60 * 16, 260 * 16);
      arrowHead(p, {16.5, 21}, {0.8, 0.4}, 6.5);
      break;
    case Glyph::kVelocity:
      for (int y : {7, 12, 17}) p.drawLine(QPointF(3, y), QPointF(y == 12 ? 14 : 9, y));
      arrowHead(p, {21, 12}, {1, 0}, 8);
      break;
    case Glyph::kClosest:
      p.drawEllipse(QPointF(5.5, 18.5), 2, 2), p.drawEllipse(QPointF(18.5, 5.5), 2, 2);
      p.drawLine(QPointF(7.2, 16.8), QPointF(16.8, 7.2));
      break;
    case Glyph::kLabel:
      p.drawRoundedRect(QRectF(3.5, 6, 17, 10), 2, 2), p.drawLine(QPointF(7, 11), QPointF(17, 11));
      p.drawLine(QPointF(9, 16), QPointF(7, 20));
      break;
    case Glyph::kFloor:
      p.drawPolygon(QVector<QPointF>{{8, 7}, {16, 7}, {22, 18}, {2, 18}});
      p.drawLine(QPointF(12, 7), QPointF(12, 18)), p.drawLine(QPointF(5.4, 12), QPointF(18.6, 12));
      break;
    case Glyph::kShadow:
      p.drawEllipse(QPointF(12, 8.5), 5, 5);
      p.setBrush(p.pen().color()), p.drawEllipse(QPointF(13, 19), 7, 1.6);
      break;
    case Glyph::kReact:
      // What comes, and what goes away from it.
      p.setBrush(p.pen().color()), p.drawEllipse(QPointF(5.5, 12), 2.6, 2.6), p.setBrush(Qt::NoBrush);
      p.drawArc(QRectF(-1, 5.5, 13, 13), -50 * 16, 100 * 16);
      p.drawLine(QPointF(14.5, 12), QPointF(17, 12)), arrowHead(p, {22.5, 12}, {1, 0}, 7);
      break;
    default:
      p.drawEllipse(QPointF(12, 6), 3, 3);
      p.drawPath([] {
        QPainterPath body(QPointF(6, 20));
        body.cubicTo(6, 9.5, 18, 9.5, 18, 20);
        body.closeSubpath();
        return body;
      }());
  }
}

void general(QPainter& p, Glyph glyph) {
  switch (glyph) {
    case Glyph::kOpen:
      p.drawPolygon(QVector<QPointF>{{3, 19}, {3, 6}, {9, 6}, {11, 8.5}, {19, 8.5}, {19, 11}});
      p.drawPolygon(QVector<QPointF>{{3, 19}, {6.5, 11}, {22, 11}, {18.5, 19}});
      break;
    case Glyph::kRecording:
      p.drawEllipse(QPointF(12, 12), 8, 8);
      p.setBrush(p.pen().color()), p.drawEllipse(QPointF(12, 12), 3.4, 3.4);
      break;
    case Glyph::kCamera:
      p.drawRoundedRect(QRectF(3, 7, 18, 12), 2, 2), p.drawEllipse(QPointF(12, 13), 3.4, 3.4);
      p.drawLine(QPointF(9, 4.5), QPointF(15, 4.5));
      break;
    case Glyph::kFit:
      for (int q = 0; q < 4; ++q) {
        p.drawPolyline(QVector<QPointF>{{4, 9}, {4, 4}, {9, 4}});
        p.translate(12, 12), p.rotate(90), p.translate(-12, -12);
      }
      p.setBrush(p.pen().color()), p.drawEllipse(QPointF(12, 12), 2.6, 2.6);
      break;
    case Glyph::kIso:
      cube(p, -1);
      break;
    case Glyph::kTop:
      cube(p, 0);
      break;
    case Glyph::kFront:
      cube(p, 1);
      break;
    case Glyph::kSide:
      cube(p, 2);
      break;
    case Glyph::kLocked:
    case Glyph::kUnlocked: {
      const bool closed = glyph == Glyph::kLocked;
      p.setBrush(closed ? QBrush(p.pen().color()) : QBrush(Qt::NoBrush));
      p.drawRoundedRect(QRectF(5, 11, 14, 10), 1.5, 1.5);
      p.setBrush(Qt::NoBrush);
      p.drawArc(closed ? QRectF(8, 3, 8, 12) : QRectF(12, 2, 8, 12), 0, 180 * 16);
      if (closed) p.drawLine(QPointF(8, 9), QPointF(8, 11)), p.drawLine(QPointF(16, 9), QPointF(16, 11));
      if (!closed) p.drawLine(QPointF(12, 8), QPointF(12, 11));
      break;
    }
    case Glyph::kTheme:
      p.drawEllipse(QPointF(12, 12), 8, 8);
      p.setBrush(p.pen().color()), p.drawChord(QRectF(4, 4, 16, 16), 90 * 16, 180 * 16);
      break;
    default:
      p.drawEllipse(QPointF(12, 12), 8.5, 8.5);
      p.drawArc(QRectF(9, 6.5, 6, 6), -60 * 16, 220 * 16), p.drawLine(QPointF(12, 12.5), QPointF(12, 14.5));
      p.fillRect(QRectF(11, 16.3, 2, 2), p.pen().color());
  }
}

class GlyphEngine : public QIconEngine {
 public:
  explicit GlyphEngine(Glyph glyph) : glyph_{glyph} {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    QPainter& p = *painter;
    p.save();
    p.setRenderHint(QPainter::Antialiasing);
    p.translate(rect.topLeft());
    p.scale(rect.width() / 24.0, rect.height() / 24.0);
    p.setPen(QPen(QApplication::palette().color(group, QPalette::ButtonText), 1.7, Qt::SolidLine,
                  Qt::RoundCap, Qt::RoundJoin));
    if (glyph_ >= Glyph::kPlay && glyph_ <= Glyph::kLoop)
      transport(p, glyph_);
    else if (glyph_ >= Glyph::kForce && glyph_ <= Glyph::kBody)
      showing(p, glyph_);
    else
      general(p, glyph_);
    p.restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new GlyphEngine(glyph_); }

 private:
  Glyph glyph_;
};

class SwatchEngine : public QIconEngine {
 public:
  explicit SwatchEngine(const QColor& colour) : colour_{colour} {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode, QIcon::State) override {
    painter->fillRect(rect, colour_);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode, QIcon::State) override {
    QPixmap pixmap(size);
    pixmap.fill(colour_);
    return pixmap;
  }

  QIconEngine* clone() const override { return new SwatchEngine(colour_); }

 private:
  QColor colour_;
};

QPixmap programPixmap(int size) {
  QPixmap pixmap(size, size);
  pixmap.fill(Qt::transparent);
  QPainter p(&pixmap);
  p.setRenderHint(QPainter::Antialiasing);
  p.scale(size / 24.0, size / 24.0);
  p.setPen(Qt::NoPen);
  p.setBrush(QColor(kAccent));
  p.drawRoundedRect(QRectF(0.5, 0.5, 23, 23), 5, 5);
  p.setBrush(Qt::white);
  p.drawEllipse(QPointF(6, 6.5), 2.3, 2.3);
  p.drawRoundedRect(QRectF(3.6, 9.6, 4.8, 10.4), 2.2, 2.2);
  p.setPen(QPen(Qt::white, 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(Qt::NoBrush);
  p.drawPolyline(QVector<QPointF>{{19, 19.4}, {19, 11}, {15.4, 6.4}});
  p.setPen(QPen(QColor(kAmber), 1.8, Qt::SolidLine, Qt::RoundCap));
  p.drawLine(QPointF(10.6, 14.6), QPointF(16, 14.6));
  return pixmap;
}

}  // namespace

QIcon swatch(const QColor& colour) { return QIcon(new SwatchEngine(colour)); }

QIcon programIcon() {
  QIcon all;
  for (const int size : {16, 24, 32, 48, 64, 128, 256}) all.addPixmap(programPixmap(size));
  return all;
}

QIcon icon(Glyph glyph) { return glyph == Glyph::kNone ? QIcon() : QIcon(new GlyphEngine(glyph)); }

}  // namespace abstand::ui
