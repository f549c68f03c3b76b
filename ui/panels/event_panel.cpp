// The table of events.
#include "ui/panels/event_panel.hpp"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QIcon>
#include <QLabel>
#include <QMenu>
#include <QPixmap>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "ui/model/event_table_model.hpp"
#include "ui/model/event_text.hpp"
#include "ui/panels/title_width.hpp"
#include "ui/style/elided_label.hpp"

namespace abstand::ui {

namespace {

constexpr int kKindSpace = 34;  // px, about the name of a kind and its colour
constexpr int kSwatch = 12;     // px
// In the menu.
constexpr EventKind kKinds[] = {EventKind::kContact, EventKind::kBetweenFrames, EventKind::kInside,
                                EventKind::kNear,    EventKind::kStop,          EventKind::kLost};

QIcon swatch(EventKind kind) {
  QPixmap picture(kSwatch, kSwatch);
  picture.fill(kindColour(kind));
  return QIcon(picture);
}

/// Leaves out the kinds that are not shown.
class EventFilter : public QSortFilterProxyModel {
 public:
  EventFilter(const EventTableModel& model, const RecordingReview& review, QObject* parent)
      : QSortFilterProxyModel(parent), model_(model), review_(review) {}

 protected:
  bool filterAcceptsRow(int row, const QModelIndex&) const override {
    return review_.shownKinds()[static_cast<std::size_t>(model_.at(row).kind)];
  }

 private:
  const EventTableModel& model_;
  const RecordingReview& review_;
};

}  // namespace

EventPanel::EventPanel(const RecordingReview& review, QWidget* parent)
    : QWidget(parent),
      review_(review),
      model_{new EventTableModel(review, this)},
      kinds_{new QToolButton(this)},
      count_{new ElidedLabel(this)},
      table_{new QTableView(this)} {
  buildKinds();
  count_->setForegroundRole(QPalette::PlaceholderText);
  sorted_ = new EventFilter(*model_, review_, this);
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
  head->addWidget(kinds_);
  head->addWidget(count_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(table_, 1);

  connect(&review_, &RecordingReview::changed, this, [this] {
    if (isVisible() || !review_.store()) refresh();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& row) { choose(row); });
  connect(table_, &QTableView::clicked, this, &EventPanel::choose);
  refresh();
}

void EventPanel::buildKinds() {
  kinds_->setObjectName(QStringLiteral("event_kinds"));
  kinds_->setText(tr("Kinds"));
  kinds_->setAccessibleName(tr("Kinds of events"));
  kinds_->setToolTip(tr("Kinds of events that the table, the markers and the keys N and Shift+N show"));
  kinds_->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(kinds_);
  for (const EventKind kind : kKinds) {
    QAction* action = menu->addAction(swatch(kind), kindText(kind));
    action->setCheckable(true);
    action->setChecked(true);
    kind_actions_[static_cast<std::size_t>(kind)] = action;
    connect(action, &QAction::toggled, this, [this] {
      EventKinds kinds;
      for (std::size_t k = 0; k < kEventKinds; ++k) kinds.set(k, kind_actions_[k]->isChecked());
      Q_EMIT kindsWanted(kinds);
    });
  }
  kinds_->setMenu(menu);
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
  std::array<long, kEventKinds> counts{};
  for (const RecordingEvent& event : review_.events()) ++counts[static_cast<std::size_t>(event.kind)];
  QStringList texts;
  for (const EventKind kind : kKinds)
    if (const long count = counts[static_cast<std::size_t>(kind)]; count > 0)
      texts << tr("%1: %2").arg(kindText(kind)).arg(count);
  count_->setText(texts.isEmpty() ? tr("no events") : texts.join(QStringLiteral(", ")));
}

void EventPanel::choose(const QModelIndex& index) {
  if (!index.isValid()) return;
  const RecordingEvent event = model_->at(sorted_->mapToSource(index).row());
  if (event.part >= 0) {
    Q_EMIT picked(event.t_nearest, event.part, event.link);
    return;
  }
  Q_EMIT stopPicked(event.t_nearest, event.pair);
}

}  // namespace abstand::ui
