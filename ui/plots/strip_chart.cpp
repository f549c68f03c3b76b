// One quantity over time, drawn with Qwt.
#include "ui/plots/strip_chart.hpp"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_plot_renderer.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QTextDocument>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "ui/plots/trace.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {

constexpr double kShortestWindow = 0.05;  // s
constexpr double kZoomStep = 0.8;         // a notch of the wheel
constexpr int kTimeLabelOverhang = 14;    // px
constexpr int kMinHeight = 90;            // px
constexpr int kMinPlot = 32;              // px, below the names of several lines, without the time axis
constexpr double kValueRoom = 1.5;        // lines of text for each value of the axis
constexpr int kMinValues = 2, kMaxValues = 4;
constexpr int kSpareWidth = 24;           // px, so that the room of a value seldom changes
constexpr double kValueAxisWidth = 44.0;  // px; the same for all charts, so that their times line up

}  // namespace

StripChart::StripChart(Text text, const QColor& colour, QWidget* parent)
    : QWidget(parent),
      text_{std::move(text)},
      plot_{new QwtPlot(this)},
      title_{new QLabel(this)},
      value_{new QLabel(this)},
      values_box_{new QWidget(this)},
      values_{new QLabel(values_box_)},
      traces_{new Trace},
      grid_{new QwtPlotGrid} {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(6, 2, 8, 0);
  QFont font = title_->font();
  font.setWeight(QFont::DemiBold);
  title_->setFont(font);
  value_->setFont(font);
  value_->setAlignment(Qt::AlignRight);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  head->addWidget(title_, 1);
  head->addWidget(value_);
  layout->addLayout(head);
  values_->setContentsMargins(6, 0, 8, 0);
  values_->setTextFormat(Qt::RichText);
  values_->setWordWrap(true);
  values_box_->hide();
  layout->addWidget(values_box_);
  layout->addWidget(plot_, 1);

  traces_[0]->factor = text_.factor;
  traces_[0]->colour = colour;
  traces_[0]->attach(plot_);
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
  values_->setFont(small);
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
  plot_->setAxisMaxMajor(QwtPlot::xBottom, 6);
  if (text_.time_axis) {
    QwtText axis_title(tr("Time [s]"));
    axis_title.setFont(small);
    plot_->setAxisTitle(QwtPlot::xBottom, axis_title);
  } else {
    plot_->axisScaleDraw(QwtPlot::xBottom)->enableComponent(QwtAbstractScaleDraw::Labels, false);
  }
  setQuantity(text_.quantity, text_.unit);
  setToolTip(tr("Drag to move the time, wheel to zoom, right button to move the window"));
  setMinimumHeight(kMinHeight);
  applyPalette();
}

StripChart::~StripChart() = default;

void StripChart::setQuantity(const QString& quantity, const QString& unit) {
  text_.quantity = quantity;
  text_.unit = unit;
  title_->setText(tr("%1 [%2]").arg(quantity, unit));
  setAccessibleName(tr("%1 over time").arg(quantity));
  dirty_ = true;
}

void StripChart::setUnit(const QString& unit, double factor, int decimals) {
  const double change = factor / text_.factor;
  text_.factor = factor;
  text_.decimals = decimals;
  for (Trace* trace : traces_) trace->factor = factor;
  traces_[0]->band_high *= change;
  high_ = low_ = 0.0;
  setQuantity(text_.quantity, unit);
}

void StripChart::setLines(const std::vector<Line>& lines) {
  while (traces_.size() > std::max<std::size_t>(1, lines.size())) {
    delete traces_.back();  // takes itself off the plot
    traces_.pop_back();
  }
  while (traces_.size() < lines.size()) {
    auto* trace = new Trace;
    trace->factor = text_.factor;
    trace->first = false;
    trace->playhead = traces_[0]->playhead;
    trace->attach(plot_);
    traces_.push_back(trace);
  }
  for (Trace* trace : traces_) {
    trace->series = nullptr;
    trace->now.reset();
  }
  names_.clear();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    traces_[i]->colour = lines[i].colour;
    traces_[i]->style = lines[i].style;
    names_.push_back(lines[i].name);
  }
  values_box_->setVisible(names_.size() > 1);
  placeValues();
  if (names_.size() > 1) {
    // Else the layout would take from the names what Qwt wants for a plot.
    const int axis = text_.time_axis ? plot_->axisWidget(QwtPlot::xBottom)->sizeHint().height() : 0;
    plot_->setMinimumHeight(kMinPlot + axis);
    setMinimumHeight(0);
  }
  value_->setVisible(names_.size() <= 1);
  dirty_ = true;
}

/// Room for the widest values, which stand one after the other. Reads no series: while the lines of one chart
/// are laid, Qt may resize its neighbours, whose series are already gone.
void StripChart::placeValues() {
  if (names_.size() > 1) {
    const QString shown = values_->text();
    values_->setText(valuesText(true));
    values_box_->setFixedHeight(values_->heightForWidth(width()) + 2);
    values_->setText(shown);
  }
  values_->setGeometry(0, 0, this->width(), values_box_->height());
}

/// As many values as stand above each other on an axis of `height` (px) without touching.
void StripChart::spaceValues(double height) {
  const double line = QFontMetricsF(plot_->axisFont(QwtPlot::yLeft)).height();
  const int room = static_cast<int>(height / (kValueRoom * line));
  plot_->setAxisMaxMajor(QwtPlot::yLeft, std::clamp(room, kMinValues, kMaxValues));
}

void StripChart::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeValues();
  dirty_ = true;
}

void StripChart::setSeries(const FrameSeries* series, std::size_t line) {
  traces_[line]->series = series;
  shown_revision_ = -1;
  dirty_ = true;
}

long StripChart::revision() const {
  long sum = 0;
  for (const Trace* trace : traces_)
    if (trace->series) sum += trace->series->revision();
  return sum;
}

QString StripChart::valuesText(bool widest) const {
  QStringList parts;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const Trace& trace = *traces_[i];
    const QString mark = trace.style == Qt::SolidLine ? QStringLiteral("━") : QStringLiteral("╍");
    // A name and its value stay together.
    const QString number =
        widest ? QStringLiteral("-8888.8") : fixed(trace.valueAtPlayhead() * text_.factor, text_.decimals);
    QString words = QStringLiteral("%1 %2").arg(names_[i], number).toHtmlEscaped();
    words.replace(QLatin1Char(' '), QLatin1String("&nbsp;"));
    // Qt would break a line behind a dash.
    words.replace(QStringLiteral("–"), QStringLiteral("\u2060–\u2060"));
    parts << QStringLiteral("<span style='color:%1'>%2</span>&nbsp;%3").arg(trace.colour.name(), mark, words);
  }
  return parts.join(QStringLiteral(" &nbsp; "));
}

void StripChart::setWindow(double left, double right) {
  if (left == left_ && right == right_) return;
  left_ = left;
  right_ = right;
  plot_->setAxisScale(QwtPlot::xBottom, left, right);
  dirty_ = true;
}

void StripChart::setPlayhead(double t) {
  if (t == traces_[0]->playhead) return;
  for (Trace* trace : traces_) {
    trace->playhead = t;
    trace->now.reset();
  }
  dirty_ = true;
}

void StripChart::setNow(double value, std::size_t line) {
  if (traces_[line]->now == value) return;
  traces_[line]->now = value;
  dirty_ = true;
}

double StripChart::shownNow(std::size_t line) const { return traces_[line]->valueAtPlayhead(); }

void StripChart::setBand(double high, const QString& text) {
  const double scaled = high * text_.factor;
  if (scaled == traces_[0]->band_high && text == traces_[0]->band_text) return;
  traces_[0]->band_high = scaled;
  traces_[0]->band_text = text;
  dirty_ = true;
}

void StripChart::refresh() {
  const long now = revision();
  if (!dirty_ && now == shown_revision_) return;
  dirty_ = false;
  shown_revision_ = now;
  fitValues();
  spaceValues(plot_->canvas()->height());
  const double value = shownNow() * text_.factor;
  if (names_.size() > 1) values_->setText(valuesText(false));
  const QString text = QStringLiteral("%1 %2").arg(fixed(value, text_.decimals), text_.unit);
  const int room = value_->fontMetrics().horizontalAdvance(text) + 4;
  if (room > value_->minimumWidth() || room < value_->minimumWidth() - kSpareWidth)
    value_->setFixedSize(room + kSpareWidth / 2, value_->fontMetrics().height() + 2);
  value_->setText(text);
  plot_->replot();
}

const FrameSeries* StripChart::series(std::size_t line) const { return traces_[line]->series; }

QString StripChart::lineName(std::size_t line) const {
  return names_.size() > 1 ? tr("%1: %2 [%3]").arg(text_.quantity, names_[line], text_.unit)
                           : tr("%1 [%2]").arg(text_.quantity, text_.unit);
}

void StripChart::paint(QPainter& painter, const QRectF& area) {
  dirty_ = true;
  refresh();
  painter.save();
  painter.setPen(palette().color(QPalette::WindowText));
  painter.setFont(title_->font());
  const QMarginsF beside(6.0, 2.0, 8.0, 0.0);
  QRectF rest = area.marginsRemoved(beside);
  QRectF head = rest;
  head.setHeight(title_->height());
  painter.drawText(head, Qt::AlignLeft, title_->text());
  if (names_.size() <= 1) painter.drawText(head, Qt::AlignRight, value_->text());
  rest.setTop(head.bottom());
  if (names_.size() > 1) {
    QTextDocument values;
    values.setDefaultFont(values_->font());
    values.setDocumentMargin(0.0);
    values.setTextWidth(rest.width());
    values.setHtml(QStringLiteral("<span style='color:%1'>%2</span>")
                       .arg(palette().color(QPalette::WindowText).name(), valuesText(false)));
    painter.translate(rest.topLeft());
    values.drawContents(&painter);
    painter.translate(-rest.topLeft());
    rest.setTop(rest.top() + values_box_->height());
  }
  painter.restore();
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardBackground);
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardCanvasBackground);
  const QRectF plot(area.left(), rest.top(), area.width(), area.bottom() - rest.top());
  spaceValues(plot.height());
  plot_->updateAxes();
  renderer.render(plot_, &painter, plot);
  dirty_ = true;  // the axis is that of the picture
}

void StripChart::fitValues() {
  Extremes seen{std::nan(""), std::nan("")};
  for (const Trace* trace : traces_) {
    if (!trace->series) continue;
    const Extremes one = trace->series->between(left_, right_);
    seen = {std::fmin(seen.low, one.low), std::fmax(seen.high, one.high)};
  }
  // Zero and the band are always in sight, and a flat line has room above it.
  double low = std::fmin(0.0, seen.low * text_.factor);
  double high = std::fmax(traces_[0]->band_high, seen.high * text_.factor);
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
