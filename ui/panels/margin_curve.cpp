// What the margin of a body part costs.
#include "ui/panels/margin_curve.hpp"

#include <QComboBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/model/event_text.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/model/selection.hpp"
#include "ui/panels/curve_area.hpp"
#include "ui/style/format.hpp"

namespace abstand::ui {

namespace {

constexpr qint64 kSliceMs = 8;

}  // namespace

MarginCurve::MarginCurve(const RecordingReview& review, const Selection& selection, QWidget* parent)
    : QWidget(parent),
      review_(review),
      selection_(selection),
      parts_{new QComboBox(this)},
      sentence_{new QLabel(this)},
      area_{new CurveArea(*this)},
      work_{new QTimer(this)} {
  parts_->setAccessibleName(tr("Body part of the curve"));
  parts_->setToolTip(tr("The body part whose margin is varied; also set by the selection"));
  sentence_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  sentence_->setToolTip(tr(
      "This part alone, with the present margins of the links: the result of \"abstand tune\" for the part"));
  work_->setInterval(0);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(8, 4, 8, 2);
  head->setSpacing(10);
  head->addWidget(parts_);
  head->addWidget(sentence_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(area_, 1);
  connect(work_, &QTimer::timeout, this, &MarginCurve::compute);
  connect(&review_, &RecordingReview::changed, this, &MarginCurve::refresh);
  connect(&selection_, &Selection::changed, this, &MarginCurve::followSelection);
  connect(parts_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &MarginCurve::refresh);
}

QWidget* MarginCurve::area() const { return area_; }
QPoint MarginCurve::handle() const { return area_->handle(); }
int MarginCurve::xOf(double metres) const { return static_cast<int>(std::lround(area_->xOf(metres))); }

bool MarginCurve::complete() const {
  return points_.size() == static_cast<std::size_t>(std::lround(kRightEnd / kStep)) + 1;
}

int MarginCurve::object() const {
  return part_ < 0
             ? -1
             : static_cast<int>(review_.store()->layout().parts[static_cast<std::size_t>(part_)].object);
}

double MarginCurve::present() const { return part_ < 0 ? 0.0 : review_.objectMargin(object()); }

void MarginCurve::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void MarginCurve::fillParts() {
  const QSignalBlocker quiet(parts_);
  parts_->clear();
  if (!review_.store()) return;
  for (std::size_t part = 0; part < review_.store()->layout().parts.size(); ++part)
    parts_->addItem(partText(*review_.store(), part));
  followSelection();
}

void MarginCurve::followSelection() {
  if (!review_.store()) return;
  const auto& parts = review_.store()->layout().parts;
  for (std::size_t part = 0; part < parts.size(); ++part)
    if (selection_.contains(static_cast<int>(parts[part].object)))
      return parts_->setCurrentIndex(static_cast<int>(part));
}

void MarginCurve::refresh() {
  const bool done = review_.store() && review_.state() == view::AnalysisNews::State::kDone;
  if (!done) {
    part_ = -1;
    opened_ = -1;
    work_->stop();
    points_.clear();
  }
  if (!isVisible()) return;
  if (done) {
    if (opened_ != review_.opened()) {
      opened_ = review_.opened();
      part_ = -1;
      fillParts();
    }
    const int part = parts_->currentIndex();
    margin::PartMargins links = review_.linkMargins(static_cast<std::size_t>(std::max(0, part)));
    if (part >= 0 && (part != part_ || links != made_for_)) {
      part_ = part;
      made_for_ = std::move(links);
      points_.clear();
      work_->start();
    }
  }
  say();
  area_->update();
}

void MarginCurve::compute() {
  QElapsedTimer slice;
  slice.start();
  while (!complete() && slice.elapsed() < kSliceMs) {
    const double margin = kStep * static_cast<double>(points_.size());
    points_.push_back({margin, review_.outcomeOf(static_cast<std::size_t>(part_), margin)});
  }
  if (complete()) work_->stop();
  area_->update();
}

void MarginCurve::say() {
  if (!review_.available())
    return sentence_->setText(tr("There is a curve where a scene has a person and a robot"));
  if (review_.state() == view::AnalysisNews::State::kLive)
    return sentence_->setText(tr("There is a curve of a recording, not of a running server"));
  if (part_ < 0)
    return sentence_->setText(review_.state() == view::AnalysisNews::State::kFailed
                                  ? tr("The analysis of the recording failed")
                                  : tr("After the analysis of the recording (%1 %)")
                                        .arg(static_cast<int>(100.0 * review_.progress())));
  sentence_->setText(tr("%1: %2").arg(
      lengthText(present(), 0), outcomeText(review_.outcomeOf(static_cast<std::size_t>(part_), present()))));
}

}  // namespace abstand::ui
