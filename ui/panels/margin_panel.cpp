// Safety margins by group.
#include "ui/panels/margin_panel.hpp"

#include <QFrame>
#include <QPushButton>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/model/groups.hpp"
#include "ui/panels/margin_row.hpp"

namespace abstand::ui {

MarginPanel::MarginPanel(QWidget* parent) : QScrollArea(parent), gather_{new QTimer(this)} {
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setAccessibleName(tr("Safety margins"));
  gather_->setSingleShot(true);
  gather_->setInterval(kGatherMs);
  connect(gather_, &QTimer::timeout, this, &MarginPanel::send);
}

void MarginPanel::open(const view::SceneOutline& outline, const std::vector<double>& margins) {
  gather_->stop();
  waiting_.clear();
  group_rows_.clear();
  masters_.clear();
  rows_.assign(outline.objects.size(), nullptr);

  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(2);
  if (!outline.objects.empty()) {
    auto* reset = new QPushButton(tr("Reset all"), content);
    reset->setFocusPolicy(Qt::TabFocus);
    reset->setToolTip(tr("All safety margins as the scene file says"));
    connect(reset, &QPushButton::clicked, this, &MarginPanel::resetWanted);
    layout->addWidget(reset, 0, Qt::AlignRight);
  }
  for (const Group& group : groupsOf(outline)) {
    const QString name = QString::fromStdString(group.name);
    auto* master = new MarginRow(name, true, content);
    layout->addWidget(master);
    for (const int object : group.objects) {
      const auto i = static_cast<std::size_t>(object);
      auto* row = new MarginRow(QString::fromStdString(shortName(outline.objects[i])), false, content);
      rows_[i] = row;
      layout->addWidget(row);
      connectRow(row, {object});
    }
    connectRow(master, group.objects);
    group_rows_[name] = master;
    masters_.emplace_back(master, group.objects);
    auto* line = new QFrame(content);
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Plain);
    line->setForegroundRole(QPalette::Mid);
    layout->addSpacing(4);
    layout->addWidget(line);
    layout->addSpacing(4);
  }
  layout->addStretch();
  setWidget(content);
  setMinimumWidth(content->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
  show(margins);
}

void MarginPanel::connectRow(MarginRow* row, const std::vector<int>& objects) {
  connect(row, &MarginRow::edited, this, [this, objects](double metres) {
    for (const int object : objects) {
      rows_[static_cast<std::size_t>(object)]->show(metres);
      change(object, metres);
    }
  });
  connect(row, &MarginRow::released, this, [this] {
    gather_->stop();
    send();
  });
}

void MarginPanel::show(const std::vector<double>& margins) {
  // A row that shows its margin already may be in the middle of an edit.
  const auto set = [](MarginRow* row, double metres) {
    if (row->metres() != metres) row->show(metres);
  };
  for (std::size_t i = 0; i < std::min(rows_.size(), margins.size()); ++i) set(rows_[i], margins[i]);
  for (const auto& [master, objects] : masters_) {
    double largest = 0.0;
    for (const int object : objects)
      largest = std::max(largest, rows_[static_cast<std::size_t>(object)]->metres());
    set(master, largest);
  }
}

MarginRow* MarginPanel::row(int object) const {
  return object >= 0 && static_cast<std::size_t>(object) < rows_.size()
             ? rows_[static_cast<std::size_t>(object)]
             : nullptr;
}

MarginRow* MarginPanel::groupRow(const QString& group) const {
  const auto found = group_rows_.find(group);
  return found == group_rows_.end() ? nullptr : found->second;
}

void MarginPanel::change(int object, double metres) {
  waiting_[object] = metres;
  if (!gather_->isActive()) gather_->start();
}

bool MarginPanel::isDragged() const {
  const auto dragged = [](const MarginRow* row) { return row->isDragged(); };
  return std::any_of(rows_.begin(), rows_.end(), dragged) ||
         std::any_of(masters_.begin(), masters_.end(),
                     [&](const auto& master) { return dragged(master.first); });
}

void MarginPanel::send() {
  const QMap<int, double> margins = std::exchange(waiting_, {});
  if (!margins.isEmpty()) Q_EMIT marginsChanged(margins);
  if (!isDragged()) Q_EMIT editFinished();
}

}  // namespace abstand::ui
