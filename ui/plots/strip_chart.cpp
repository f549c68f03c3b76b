// One quantity over time, drawn with Qwt.
#include "ui/plots/strip_chart.hpp"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/format.hpp"
#include "ui/plots/trace.hpp"

namespace abstand::ui {

namespace {

constexpr double kShortestWindow = 0.05;  // s
constexpr double kZoomStep = 0.8;         // a notch of the wheel
constexpr int kTimeLabelOverhang = 14;    // px
constexpr double kValueAxisWidth = 44.0;  // px; the same for all charts, so that their times line up

}  // namespace

StripChart::StripChart(Text text, const QColor& colour, QWidget* parent)
    : QWidget(parent),
      text_{std::move(text)},
      plot_{new QwtPlot(this)},
      value_{new QLabel(this)},
      trace_{new Trace},
      grid_{new QwtPlotGrid} {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(6, 2, 8, 0);
  auto* title = new QLabel(tr("%1 [%2]").arg(text_.quantity, text_.unit), this);
  QFont font = title->font();
  font.setWeight(QFont::DemiBold);
  title->setFont(font);
  value_->setFont(font);
  value_->setAlignment(Qt::AlignRight);
  head->addWidget(title);
  head->addStretch();
  head->addWidget(value_);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);

  trace_->factor = text_.factor;
  trace_->colour = colour;
  trace_->attach(plot_);
  grid_->attach(plot_);

  auto* canvas = new QwtPlotCanvas(plot_);
  canvas->setFrameStyle(QFrame::NoFrame);
  canvas->setCursor(Qt::CrossCursor);
  canvas->setFocusPolicy(Qt::NoFocus);
  canvas->installEventFilter(this);
  plot_->setCanvas(canvas);
  plot_->setAutoReplot(false);
  plot_->plotLayout()->setAlignCanvasToScales(true);
  QFont small = plot_->font();
  small.setPointSizeF(std::max(7.0, small.pointSizeF() - 1.0));
  for (const int axis : {QwtPlot::yLeft, QwtPlot::xBottom}) {
    plot_->setAxisFont(axis, small);
    plot_->axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    plot_->axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MinorTick, 0);
    plot_->axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MediumTick, 0);
    plot_->axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MajorTick, 3);
  }
  plot_->axisScaleDraw(QwtPlot::yLeft)->setMinimumExtent(kValueAxisWidth);
  // The same overhang of the last label, whether there is one or not.
  plot_->axisWidget(QwtPlot::xBottom)->setMinBorderDist(kTimeLabelOverhang, kTimeLabelOverhang);
  plot_->setAxisMaxMajor(QwtPlot::yLeft, 4);
  plot_->setAxisMaxMajor(QwtPlot::xBottom, 6);
  if (text_.time_axis) {
    QwtText axis_title(tr("Time [s]"));
    axis_title.setFont(small);
    plot_->setAxisTitle(QwtPlot::xBottom, axis_title);
  } else {
    plot_->axisScaleDraw(QwtPlot::xBottom)->enableComponent(QwtAbstractScaleDraw::Labels, false);
  }
  setAccessibleName(tr("%1 over time").arg(text_.quantity));
  setToolTip(tr("Drag to move the time, wheel to zoom, right button to move the window"));
  setMinimumHeight(90);
  applyPalette();
}

StripChart::~StripChart() = default;

void StripChart::setSeries(const FrameSeries* series) {
  trace_->series = series;
  shown_revision_ = -1;
  dirty_ = true;
}

void StripChart::setWindow(double left, double right) {
  if (left == left_ && right == right_) return;
  left_ = left;
  right_ = right;
  plot_->setAxisScale(QwtPlot::xBottom, left, right);
  dirty_ = true;
}

void StripChart::setPlayhead(double t) {
  if (t == trace_->playhead) return;
  trace_->playhead = t;
  dirty_ = true;
}

void StripChart::setBand(double high, const QString& text) {
  const double scaled = high * text_.factor;
  if (scaled == trace_->band_high && text == trace_->band_text) return;
  trace_->band_high = scaled;
  trace_->band_text = text;
  dirty_ = true;
}

void StripChart::refresh() {
  const long revision = trace_->series ? trace_->series->revision() : 0;
  if (!dirty_ && revision == shown_revision_) return;
  dirty_ = false;
  shown_revision_ = revision;
  fitValues();
  const double value = trace_->series ? trace_->series->at(trace_->playhead) * text_.factor : std::nan("");
  value_->setText(QStringLiteral("%1 %2").arg(fixed(value, text_.decimals), text_.unit));
  plot_->replot();
}

void StripChart::fitValues() {
  Extremes seen =
      trace_->series ? trace_->series->between(left_, right_) : Extremes{std::nan(""), std::nan("")};
  // Zero and the band are always in sight, and a flat line has room above it.
  double low = std::fmin(0.0, seen.low * text_.factor);
  double high = std::fmax(trace_->band_high, seen.high * text_.factor);
  if (std::isnan(high)) high = 0.0;
  if (!(high - low > 1e-9)) high = low + 1.0;
  const double room = 0.08 * (high - low);
  high += room;
  if (low < 0.0) low -= room;
  // The axis stays while the values fill most of it, so that it does not jitter.
  const double span = high_ - low_;
  if (span > 0.0 && low >= low_ && high <= high_ && (high - low) > 0.6 * span &&
      (low_ >= 0.0) == (low >= 0.0))
    return;
  low_ = low;
  high_ = high;
  plot_->setAxisScale(QwtPlot::yLeft, low_, high_);
}

void StripChart::applyPalette() {
  const QPalette p = QApplication::palette();
  plot_->setCanvasBackground(p.color(QPalette::Base));
  QColor line = p.color(QPalette::Mid);
  line.setAlpha(140);
  grid_->setMajorPen(line, 1.0, Qt::SolidLine);
  dirty_ = true;
}

double StripChart::timeAt(int x) const { return plot_->canvasMap(QwtPlot::xBottom).invTransform(x); }

void StripChart::changeEvent(QEvent* event) {
  // Later, because a style sheet that is set anew gives the canvas its old colours back after this event.
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange)
    QTimer::singleShot(0, this, [this] {
      applyPalette();
      refresh();
    });
  QWidget::changeEvent(event);
}

bool StripChart::eventFilter(QObject* watched, QEvent* event) {
  if (watched != plot_->canvas()) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove: {
      auto* mouse = static_cast<QMouseEvent*>(event);
      if (mouse->buttons() & Qt::LeftButton) {
        Q_EMIT timePicked(timeAt(mouse->x()));
      } else if (mouse->buttons() != Qt::NoButton) {
        if (event->type() == QEvent::MouseButtonPress) drag_from_ = timeAt(mouse->x());
        const double shift = drag_from_ - timeAt(mouse->x());
        if (shift != 0.0) Q_EMIT windowMoved(left_ + shift, right_ + shift);
      }
      return true;
    }
    case QEvent::Wheel: {
      auto* wheel = static_cast<QWheelEvent*>(event);
      const double t = timeAt(static_cast<int>(wheel->position().x()));
      const double zoom = std::pow(kZoomStep, wheel->angleDelta().y() / 120.0);
      if ((right_ - left_) * zoom > kShortestWindow)
        Q_EMIT windowMoved(t - (t - left_) * zoom, t + (right_ - t) * zoom);
      return true;
    }
    default:
      return QWidget::eventFilter(watched, event);
  }
}

}  // namespace abstand::ui
