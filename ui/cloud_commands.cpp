#include "ui/cloud_commands.hpp"

#include <QAction>
#include <QComboBox>
#include <QTimer>
#include <algorithm>

#include "ui/panels/depth_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::ui {

namespace {
using Id = ActionId;
constexpr int kCloudPollMs = 10;
}  // namespace

CloudCommands::CloudCommands(const Sources& sources, QObject* parent)
    : QObject(parent), my_{sources}, timer_{new QTimer(this)} {
  timer_->setInterval(kCloudPollMs);
  connect(timer_, &QTimer::timeout, this, &CloudCommands::poll);
  for (const Id id : {Id::kCloud, Id::kCloudAll})
    connect(my_.actions[id], &QAction::toggled, this, &CloudCommands::refresh);
  connect(my_.actions[Id::kCloudConfidence], &QAction::toggled, this, &CloudCommands::show);
  for (const Id id : {Id::kCloud, Id::kCloudConfidence, Id::kCloudAll})
    connect(my_.actions[id], &QAction::triggered, this, &CloudCommands::sayChoice);
  connect(my_.panel.personBox(), QOverload<int>::of(&QComboBox::activated), this, &CloudCommands::refresh);
  open(nullptr);
}

void CloudCommands::open(CloudPort* port) {
  port_ = port;
  timer_->stop();
  wanted_.reset();
  cloud_ = {};
  problem_.clear();
  show();
}

int CloudCommands::person() const {
  return my_.actions[Id::kCloudAll]->isChecked() ? -1 : std::max(0, my_.panel.personBox()->currentIndex());
}

bool CloudCommands::hasCloudOf(const DepthCloud& cloud) const {
  return wanted_ && cloud.person == wanted_->person && cloud.images == wanted_->images;
}

bool CloudCommands::isOfMoment() const { return hasCloudOf(cloud_); }

void CloudCommands::refresh() {
  if (!port_ || !my_.actions[Id::kCloud]->isChecked()) {
    wanted_.reset();
    timer_->stop();
    return show();
  }
  DepthCloud now;
  now.person = person();
  now.images = port_->imagesAt(my_.moment.t);
  if (!hasCloudOf(now)) {
    CloudRequest request{my_.moment.t, now.person, {}};
    for (const view::ObjectSnapshot& object : my_.moment.objects) request.X_WB.push_back(object.X_WB);
    port_->ask(std::move(request));
    wanted_ = std::move(now);
    timer_->start();
  }
  poll();
}

void CloudCommands::poll() {
  DepthCloud news;
  const bool fresh = port_ && port_->take(news) && wanted_ && news.person == wanted_->person;
  if (fresh) cloud_ = std::move(news);
  if (isOfMoment()) timer_->stop();
  const bool visible = wanted_ && (isOfMoment() || my_.moment.playing);
  if (fresh || visible != shown_) show();
  if (fresh && cloud_.problem != problem_) {
    problem_ = cloud_.problem;
    if (!problem_.isEmpty()) Q_EMIT said(tr("No depth points: %1").arg(problem_));
  }
}

void CloudCommands::show() {
  shown_ = wanted_ && (isOfMoment() || my_.moment.playing);
  my_.viewport.showCloud(
      shown_ ? cloud_.points : std::vector<CloudPoint>(),
      my_.actions[Id::kCloudConfidence]->isChecked() ? CloudColours::kConfidence : CloudColours::kParts);
}

void CloudCommands::sayChoice() {
  if (!port_) Q_EMIT said(tr("The recordings of this scene have no depth images"));
}

}  // namespace abstand::ui
