// Safety margins by group.
#include "ui/panels/margin_panel.hpp"

#include <QFrame>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

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
  held_ = false;
  group_rows_.clear();
  masters_.clear();
  rows_.assign(outline.objects.size(), nullptr);
  names_.clear();
  for (const auto& object : outline.objects) names_.push_back(QString::fromStdString(object.name));

  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(2);
  for (const Group& group : groupsOf(outline)) {
    const QString name = QString::fromStdString(group.name);
    auto* master = new MarginRow(groupTitle(group), true, content);
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
    auto* line = new QFrame(content);
    masters_.push_back({master, group.objects, line, groupTitle(group)});
    line->setFrameShape(QFrame::HLine);
    line->setFrameShadow(QFrame::Plain);
    line->setForegroundRole(QPalette::Mid);
    line->setContentsMargins(0, 4, 0, 4);
    layout->addWidget(line);
  }
  layout->addStretch();
  setWidget(content);
  setMinimumWidth(content->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
  show(margins);
  setFilter(filter_);
}

void MarginPanel::connectRow(MarginRow* row, const std::vector<int>& objects) {
  connect(row, &MarginRow::edited, this, [this, objects](double metres) {
    for (const int object : objects) {
      MarginRow* member = rows_[static_cast<std::size_t>(object)];
      if (member->locked() || member->isHidden()) continue;
      member->show(metres);
      change(object, metres);
    }
  });
  connect(row, &MarginRow::lockWanted, this, [this, objects](bool locked) {
    std::vector<int> shown;
    for (const int object : objects)
      if (!rows_[static_cast<std::size_t>(object)]->isHidden()) shown.push_back(object);
    Q_EMIT lockWanted(shown, locked);
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
  for (const Master& master : masters_) {
    double largest = 0.0;
    for (const int object : master.objects)
      largest = std::max(largest, rows_[static_cast<std::size_t>(object)]->metres());
    set(master.row, largest);
  }
}

void MarginPanel::showLocked(const std::vector<bool>& locked) {
  for (std::size_t i = 0; i < std::min(rows_.size(), locked.size()); ++i) rows_[i]->setLocked(locked[i]);
  showMasterLocks();
}

/// The row of a group is locked where all of its rows are that are shown.
void MarginPanel::showMasterLocks() {
  for (const Master& master : masters_)
    master.row->setLocked(std::all_of(master.objects.begin(), master.objects.end(), [this](int object) {
      const MarginRow* row = rows_[static_cast<std::size_t>(object)];
      return row->isHidden() || row->locked();
    }));
}

void MarginPanel::setFilter(const QString& text) {
  filter_ = text.trimmed();
  for (const Master& master : masters_) {
    const bool whole = master.name.contains(filter_, Qt::CaseInsensitive);
    bool any = false;
    for (const int object : master.objects) {
      const auto i = static_cast<std::size_t>(object);
      const bool shown = whole || names_[i].contains(filter_, Qt::CaseInsensitive);
      rows_[i]->setVisible(shown);
      any |= shown;
    }
    master.row->setVisible(any);
    master.line->setVisible(any);
  }
  showMasterLocks();
}

void MarginPanel::setSelected(const std::vector<int>& objects) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    rows_[i]->setMarked(std::binary_search(objects.begin(), objects.end(), static_cast<int>(i)));
  MarginRow* first = objects.empty() ? nullptr : row(objects.front());
  if (first && !first->isHidden()) ensureWidgetVisible(first);
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

void MarginPanel::hold(int object, double metres) {
  MarginRow* held = row(object);
  if (!held || held->locked()) return;
  held_ = true;
  if (held->metres() == metres) return;
  held->show(metres);
  change(object, metres);
}

void MarginPanel::release() {
  if (!std::exchange(held_, false)) return;
  gather_->stop();
  send();
}

bool MarginPanel::isDragged() const {
  if (held_) return true;
  const auto dragged = [](const MarginRow* row) { return row->isDragged(); };
  return std::any_of(rows_.begin(), rows_.end(), dragged) ||
         std::any_of(masters_.begin(), masters_.end(),
                     [&](const Master& master) { return dragged(master.row); });
}

void MarginPanel::send() {
  const QMap<int, double> margins = std::exchange(waiting_, {});
  if (!margins.isEmpty()) Q_EMIT marginsChanged(margins);
  if (!isDragged()) Q_EMIT editFinished();
}

}  // namespace abstand::ui
