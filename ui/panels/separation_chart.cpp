// Terms of the protective distance as stacked bars against the measured distance.
#include "ui/panels/separation_chart.hpp"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/model/groups.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr int kPartName = 104, kVerdict = 150, kContact = 128, kGapBetween = 8;  // px
constexpr int kLegendHeight = 22;                                                // px
constexpr double kMinScale = 0.5;  // m, that the bars show at least
constexpr std::array<QRgb, 4> kTermColours{0xff3b6ea5, 0xff7a5aa6, 0xff4a90a4, 0xff8a949e};

std::array<double, 4> termsOf(const safety::ProtectiveDistance& needed) {
  return {needed.person, needed.reaction, needed.stopping, needed.constant};
}

}  // namespace

SeparationChart::SeparationChart(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Protective distance of each body part"));
  setMinimumWidth(kPartName + kVerdict + kContact + 120);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SeparationChart::open(const view::SceneOutline& outline) {
  outline_ = &outline;
  rows_.clear();
  updateGeometry();
  update();
}

void SeparationChart::show(const std::vector<SeparationRow>& rows, const SeparationSettings& settings) {
  const bool other_size = rows.size() != rows_.size();
  rows_ = rows;
  settings_ = settings;
  if (other_size) updateGeometry();
  update();
}

QSize SeparationChart::sizeHint() const {
  return {600, kLegendHeight + static_cast<int>(rows_.size()) * kRowHeight + 4};
}

int SeparationChart::rowAt(int y) const {
  const int row = y < kLegendHeight ? -1 : (y - kLegendHeight) / kRowHeight;
  return row < static_cast<int>(rows_.size()) ? row : -1;
}

QRect SeparationChart::bars(int row) const {
  return {kPartName + kGapBetween, kLegendHeight + row * kRowHeight,
          width() - kPartName - kVerdict - kContact - 4 * kGapBetween, kRowHeight};
}

void SeparationChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!outline_ || rows_.empty()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect(), Qt::AlignCenter,
                     tr("Body parts have rows here where a scene has a person and a robot"));
    return;
  }
  paintLegend(painter);
  double longest = kMinScale;
  for (const SeparationRow& row : rows_)
    if (row.state != SeparationState::kUnknown) longest = std::max(longest, row.needed.sum());
  // A little more, so that a clearance beyond the sum is seen as such.
  for (int row = 0; row < static_cast<int>(rows_.size()); ++row) paintRow(painter, row, 1.25 * longest);
}

void SeparationChart::paintLegend(QPainter& painter) const {
  const QString words[] = {tr("person"), tr("reaction"), tr("stopping"), tr("C + Z")};
  int x = bars(0).left();
  const int middle = kLegendHeight / 2;
  for (std::size_t k = 0; k < std::size(words); ++k) {
    painter.fillRect(QRect(x, middle - 5, 10, 10), QColor(kTermColours[k]));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRect(x + 14, 0, 100, kLegendHeight), Qt::AlignVCenter, words[k]);
    x += 14 + painter.fontMetrics().horizontalAdvance(words[k]) + 12;
  }
  painter.setPen(QPen(palette().color(QPalette::Text), 3.0));
  painter.drawLine(x + 4, middle - 6, x + 4, middle + 6);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRect(x + 12, 0, 160, kLegendHeight), Qt::AlignVCenter, tr("clearance"));
  const int right = width() - kContact;
  painter.drawText(QRect(right, 0, kContact, kLegendHeight), Qt::AlignVCenter, tr("contact now"));
}

void SeparationChart::paintRow(QPainter& painter, int index, double scale) const {
  const SeparationRow& row = rows_[static_cast<std::size_t>(index)];
  const QRect area = bars(index);
  painter.setPen(palette().color(QPalette::Text));
  const QString name = QString::fromStdString(clearName(*outline_, static_cast<std::size_t>(row.part)));
  painter.drawText(QRect(0, area.top(), kPartName, kRowHeight), Qt::AlignRight | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(name, Qt::ElideLeft, kPartName));
  const QRect bar = area.adjusted(0, 5, 0, -5);
  const auto x = [&](double metres) {
    return bar.left() + static_cast<int>(std::lround(std::clamp(metres / scale, 0.0, 1.0) * bar.width()));
  };
  if (row.state == SeparationState::kUnknown) {
    painter.fillRect(bar, QBrush(palette().color(QPalette::Mid), Qt::BDiagPattern));
  } else {
    double from = 0.0;
    const auto terms = termsOf(row.needed);
    for (std::size_t k = 0; k < terms.size(); ++k) {
      painter.fillRect(QRect(QPoint(x(from), bar.top()), QPoint(x(from + terms[k]) - 1, bar.bottom())),
                       QColor(kTermColours[k]));
      from += terms[k];
    }
    if (row.state == SeparationState::kNotKept) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(QColor(kVermillion), 2.0));
      painter.drawRect(QRect(QPoint(x(0.0), bar.top()), QPoint(x(from), bar.bottom())));
    }
    const int at = x(row.clearance);
    painter.setPen(QPen(palette().color(QPalette::Base), 5.0));
    painter.drawLine(at, area.top() + 3, at, area.bottom() - 3);
    painter.setPen(QPen(palette().color(QPalette::Text), 3.0));
    painter.drawLine(at, area.top() + 3, at, area.bottom() - 3);
  }
  painter.setPen(row.state == SeparationState::kNotKept ? QColor(kVermillion)
                                                        : palette().color(QPalette::Text));
  const QRect verdict(area.right() + kGapBetween, area.top(), kVerdict, kRowHeight);
  painter.drawText(verdict, Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(separationText(row), Qt::ElideRight, kVerdict));
  paintContact(painter, row, QRect(width() - kContact, area.top(), kContact, kRowHeight));
}

/// Shape and colour say the same.
void SeparationChart::paintContact(QPainter& painter, const SeparationRow& row, const QRect& place) const {
  const QPointF middle(place.left() + 6.0, place.center().y() + 0.5);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  switch (row.contact_state) {
    case ContactState::kNoImpact:
    case ContactState::kBelowHalf:
      painter.setBrush(palette().color(QPalette::Mid));
      painter.drawEllipse(middle, 4.5, 4.5);
      break;
    case ContactState::kBelow:
      painter.setBrush(QColor(kAmber));
      painter.drawPolygon(
          QVector<QPointF>{middle + QPointF(-5, 5), middle + QPointF(5, 5), middle + QPointF(0, -5)});
      break;
    case ContactState::kAbove:
      painter.setBrush(QColor(kVermillion));
      painter.drawRect(QRectF(middle - QPointF(5, 5), QSizeF(10, 10)));
      break;
    case ContactState::kUnknown:
      painter.setBrush(QBrush(palette().color(QPalette::Mid), Qt::BDiagPattern));
      painter.drawRect(QRectF(middle - QPointF(5, 5), QSizeF(10, 10)));
      break;
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(row.contact_state == ContactState::kAbove ? QColor(kVermillion)
                                                           : palette().color(QPalette::Text));
  painter.drawText(place.adjusted(16, 0, 0, 0), Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(contactText(row), Qt::ElideRight, place.width() - 16));
}

void SeparationChart::mousePressEvent(QMouseEvent* event) {
  const int row = rowAt(event->y());
  if (event->button() == Qt::LeftButton && row >= 0 && rows_[static_cast<std::size_t>(row)].pair >= 0)
    Q_EMIT pairPicked(rows_[static_cast<std::size_t>(row)].pair);
}

bool SeparationChart::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && outline_) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int row = rowAt(help->y());
    if (row >= 0)
      QToolTip::showText(help->globalPos(),
                         separationTip(*outline_, rows_[static_cast<std::size_t>(row)], settings_), this);
    return true;
  }
  return QWidget::event(event);
}

}  // namespace abstand::ui
