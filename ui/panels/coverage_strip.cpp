#include "ui/panels/coverage_strip.hpp"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/model/coverage_text.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {

constexpr int kSpanSlack = 3;  // px beside a span that belong to it

}  // namespace

const CoveragePart* CoverageStrip::partOf(int row) const {
  if (!report_ || row < 0 || row >= static_cast<int>(report_->parts.size())) return nullptr;
  return &report_->parts[static_cast<std::size_t>(row)];
}

double CoverageStrip::timeAt(const QRect& cell, int x) const {
  const QRect area = band(cell);
  if (!report_ || area.width() <= 1) return 0.0;
  const double f = std::clamp(static_cast<double>(x - area.left()) / (area.width() - 1), 0.0, 1.0);
  return report_->from + f * (report_->to - report_->from);
}

int CoverageStrip::xOf(const QRect& cell, double t) const {
  const QRect area = band(cell);
  if (!(report_->to > report_->from)) return area.left();
  const double f = std::clamp((t - report_->from) / (report_->to - report_->from), 0.0, 1.0);
  return area.left() + static_cast<int>(std::lround(f * (area.width() - 1)));
}

const CoverageSpan* CoverageStrip::spanAt(int row, double t, double slack) const {
  const CoveragePart* part = partOf(row);
  if (!part) return nullptr;
  const CoverageSpan* nearest = nullptr;
  double distance = slack;
  for (const CoverageSpan& span : part->spans) {
    const double away = std::max({0.0, span.from - t, t - span.to});
    if (away > distance || (nearest && away == distance)) continue;
    nearest = &span;
    distance = away;
  }
  return nearest;
}

void CoverageStrip::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  QStyledItemDelegate::paint(painter, option, index);
  const CoveragePart* part = partOf(index.row());
  if (!part) return;
  const QRect area = band(option.rect);
  painter->save();
  painter->fillRect(area, option.palette.color(QPalette::AlternateBase));
  for (const CoverageSpan& span : part->spans) {
    const int left = xOf(option.rect, span.from), right = xOf(option.rect, span.to);
    painter->fillRect(left, area.top(), std::max(2, right - left), area.height(), hiddenColour(span.cause));
  }
  painter->setPen(option.palette.color(QPalette::Mid));
  painter->drawRect(area.adjusted(-1, -1, 0, 0));
  const int now = xOf(option.rect, time_);
  painter->setPen(QPen(option.palette.color(QPalette::Base), 3.0));
  painter->drawLine(now, option.rect.top(), now, option.rect.bottom());
  painter->setPen(QPen(option.palette.color(QPalette::Text), 1.0));
  painter->drawLine(now, option.rect.top(), now, option.rect.bottom());
  painter->restore();
}

bool CoverageStrip::editorEvent(QEvent* event, QAbstractItemModel*, const QStyleOptionViewItem& option,
                                const QModelIndex& index) {
  if (event->type() != QEvent::MouseButtonRelease || !partOf(index.row())) return false;
  const int x = static_cast<QMouseEvent*>(event)->x();
  const double t = timeAt(option.rect, x);
  const CoverageSpan* span =
      spanAt(index.row(), t, timeAt(option.rect, x + kSpanSlack) - timeAt(option.rect, x));
  Q_EMIT picked(span ? span->from : t);
  return true;
}

bool CoverageStrip::helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                              const QModelIndex& index) {
  const CoveragePart* part = partOf(index.row());
  if (event->type() != QEvent::ToolTip || !part)
    return QStyledItemDelegate::helpEvent(event, view, option, index);
  const int x = event->pos().x();
  const double t = timeAt(option.rect, x);
  const CoverageSpan* span =
      spanAt(index.row(), t, timeAt(option.rect, x + kSpanSlack) - timeAt(option.rect, x));
  QToolTip::showText(event->globalPos(),
                     span ? spanText(*part, *span) : tr("%1: seen at %2").arg(part->name, secondsWithUnit(t)),
                     view);
  return true;
}

}  // namespace abstand::ui
