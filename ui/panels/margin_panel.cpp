// Safety margins by group.
#include "ui/panels/margin_panel.hpp"

#include <QFrame>
#include <QPushButton>
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
  first_ = margins;
  first_.resize(outline.objects.size(), 0.0);

  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 6, 8, 6);
  layout->setSpacing(2);
  if (!outline.objects.empty()) {
    auto* reset = new QPushButton(tr("Reset all"), content);
    reset->setToolTip(tr("All safety margins as when the scene was opened"));
    connect(reset, &QPushButton::clicked, this, &MarginPanel::reset);
    layout->addWidget(reset, 0, Qt::AlignRight);
  }
  for (const Group& group : groupsOf(outline)) {
    const QString name = QString::fromStdString(group.name);
    auto* master = new MarginRow(name, true, content);
    double largest = 0.0;
    layout->addWidget(master);
    for (const int object : group.objects) {
      const auto i = static_cast<std::size_t>(object);
      auto* row = new MarginRow(QString::fromStdString(shortName(outline.objects[i])), false, content);
      row->show(first_[i]);
      largest = std::max(largest, first_[i]);
      rows_[i] = row;
      layout->addWidget(row);
      connect(row, &MarginRow::edited, this, [this, object](double metres) { change(object, metres); });
    }
    master->show(largest);
    connect(master, &MarginRow::edited, this, [this, objects = group.objects](double metres) {
      for (const int object : objects) {
        rows_[static_cast<std::size_t>(object)]->show(metres);
        change(object, metres);
      }
    });
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

void MarginPanel::reset() {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i]->metres() == first_[i]) continue;
    rows_[i]->show(first_[i]);
    change(static_cast<int>(i), first_[i]);
  }
  for (const auto& [master, objects] : masters_) {
    double largest = 0.0;
    for (const int object : objects) largest = std::max(largest, first_[static_cast<std::size_t>(object)]);
    master->show(largest);
  }
}

void MarginPanel::change(int object, double metres) {
  waiting_[object] = metres;
  if (!gather_->isActive()) gather_->start();
}

void MarginPanel::send() {
  const std::map<int, double> changes = std::exchange(waiting_, {});
  for (const auto& [object, metres] : changes) Q_EMIT marginChanged(object, metres);
}

}  // namespace abstand::ui
