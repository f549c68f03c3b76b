// The table of events.
#include "ui/panels/event_panel.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/event_table_model.hpp"
#include "ui/model/event_text.hpp"
#include "ui/panels/title_width.hpp"

namespace abstand::ui {

namespace {

using EventKind = margin::ReviewEvent::Kind;

constexpr int kKindSpace = 16;  // px, about the name of a kind

/// Leaves out near misses on request.
class EventFilter : public QSortFilterProxyModel {
 public:
  EventFilter(const EventTableModel& model, const QCheckBox& near, QObject* parent)
      : QSortFilterProxyModel(parent), model_(model), near_(near) {}

 protected:
  bool filterAcceptsRow(int row, const QModelIndex&) const override {
    return near_.isChecked() || model_.at(row).kind != EventKind::kNear;
  }

 private:
  const EventTableModel& model_;
  const QCheckBox& near_;
};

}  // namespace

EventPanel::EventPanel(const RecordingReview& review, QWidget* parent)
    : QWidget(parent),
      review_(review),
      model_{new EventTableModel(review, this)},
      near_{new QCheckBox(tr("Near misses"), this)},
      count_{new QLabel(this)},
      table_{new QTableView(this)} {
  near_->setChecked(true);
  near_->setToolTip(tr("Show what came nearer than twice the margin without coming inside"));
  count_->setForegroundRole(QPalette::PlaceholderText);
  sorted_ = new EventFilter(*model_, *near_, this);
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(EventTableModel::kSortRole);
  table_->setModel(sorted_);
  table_->setAccessibleName(tr("Events"));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->setSortingEnabled(true);
  table_->sortByColumn(EventTableModel::kTime, Qt::AscendingOrder);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setStretchLastSection(true);
  const int kind_width =
      table_->fontMetrics().horizontalAdvance(kindText(EventKind::kBetweenFrames)) + kKindSpace;
  for (const auto& [column, width] : {std::pair{+EventTableModel::kKind, std::max(150, kind_width)},
                                      {+EventTableModel::kPart, 130},
                                      {+EventTableModel::kLink, 130},
                                      {+EventTableModel::kClearance, 120}})
    table_->horizontalHeader()->resizeSection(column, width);
  fitTitles(*table_->horizontalHeader());

  auto* head = new QHBoxLayout;
  head->setContentsMargins(8, 5, 8, 3);
  head->addWidget(near_);
  head->addStretch();
  head->addWidget(count_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(table_, 1);

  connect(&review_, &RecordingReview::changed, this, [this] {
    if (isVisible() || !review_.store()) refresh();
  });
  connect(near_, &QCheckBox::toggled, sorted_, [this] { sorted_->invalidate(); });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& row) { choose(row); });
  connect(table_, &QTableView::clicked, this, &EventPanel::choose);
  refresh();
}

void EventPanel::showEvent(QShowEvent* event) {
  refresh();
  QWidget::showEvent(event);
}

void EventPanel::refresh() {
  if (shown_ == review_.revision()) return;
  shown_ = review_.revision();
  // Rows that go are not chosen anew.
  const QSignalBlocker quiet(table_->selectionModel());
  model_->refresh();
  const auto& events = review_.review().events;
  const auto near = std::count_if(events.begin(), events.end(),
                                  [](const auto& event) { return event.kind == EventKind::kNear; });
  count_->setText(
      tr("%1 intrusions and touches, %2 near misses").arg(static_cast<long>(events.size()) - near).arg(near));
}

void EventPanel::choose(const QModelIndex& index) {
  if (!index.isValid()) return;
  const margin::ReviewEvent& event = model_->at(sorted_->mapToSource(index).row());
  Q_EMIT picked(event.t_nearest, event.part, event.link);
}

}  // namespace abstand::ui
