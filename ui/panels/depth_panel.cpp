#include "ui/panels/depth_panel.hpp"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/panels/depth_view.hpp"
#include "ui/style/format.hpp"
#include "ui/style/theme.hpp"

namespace abstand::ui {

namespace {

constexpr int kPollMs = 15;  // an image takes about as long

QString mark(JointLook look, QChar sign) {
  // The colours are those of marks on a dark image.
  return QStringLiteral("<span style='background:#30363e;color:%1'>&nbsp;%2&nbsp;</span>")
      .arg(QColor(DepthView::colourOf(look)).name())
      .arg(sign);
}

}  // namespace

DepthPanel::DepthPanel(QAction* body, QWidget* parent)
    : QWidget(parent),
      view_{new DepthView(this)},
      person_{new QComboBox(this)},
      caption_{new QLabel(this)},
      legend_{new QLabel(this)},
      timer_{new QTimer(this)} {
  person_->setAccessibleName(tr("Whose depth image"));
  person_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  for (QLabel* label : {caption_, legend_}) {
    label->setWordWrap(true);
    label->setMinimumWidth(0);
  }
  caption_->setAccessibleName(tr("Image and camera"));
  legend_->setAccessibleName(tr("States of the joints"));
  caption_->setTextFormat(Qt::PlainText);
  caption_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  body->setIconText(tr("Body"));
  auto* body_button = new QToolButton(this);
  body_button->setDefaultAction(body);
  body_button->setToolButtonStyle(Qt::ToolButtonTextOnly);
  auto* row = new QHBoxLayout;
  row->addWidget(legend_, 1);
  row->addWidget(person_);
  row->addWidget(body_button);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 6);
  layout->setSpacing(4);
  layout->addWidget(view_, 1);
  layout->addWidget(caption_);
  layout->addLayout(row);
  timer_->setInterval(kPollMs);
  connect(timer_, &QTimer::timeout, this, &DepthPanel::poll);
  connect(body, &QAction::toggled, view_, &DepthView::setBodyShown);
  view_->setBodyShown(body->isChecked());
  connect(person_, QOverload<int>::of(&QComboBox::activated), this, &DepthPanel::choose);
  open(nullptr);
}

void DepthPanel::open(DepthPort* port) {
  port_ = port;
  timer_->stop();
  wanted_ = {};
  person_->clear();
  if (port_)
    for (const DepthSummary& person : port_->people()) person_->addItem(person.person);
  person_->setVisible(person_->count() > 1);
  view_->showMessage(port_ ? QString() : tr("The recordings of this scene have no depth images"));
  showState();
}

void DepthPanel::refresh(const view::SceneSnapshot& snapshot) {
  t_ = snapshot.t;
  if (!port_ || !in_front_) return;
  const int person = std::max(0, person_->currentIndex());
  const std::size_t image = port_->imageAt(person, t_);
  if (person != wanted_.person || image != wanted_.image) {
    wanted_ = {person, image};
    port_->ask(person, image);
    timer_->start();
  }
  poll();
}

void DepthPanel::choose(int) {
  view::SceneSnapshot moment;
  moment.t = t_;
  refresh(moment);
}

bool DepthPanel::isOfMoment() const {
  const DepthPicture& shown = view_->picture();
  return shown.person >= 0 && shown.person == wanted_.person && shown.image == wanted_.image;
}

void DepthPanel::poll() {
  if (!port_) return;
  DepthPicture picture;
  if (port_->take(picture) && picture.person == wanted_.person) view_->show(picture);
  if (isOfMoment()) timer_->stop();
  showState();
}

void DepthPanel::showState() {
  showCaption();
  showLegend();
}

void DepthPanel::showCaption() {
  const DepthPicture& shown = view_->picture();
  caption_->setVisible(shown.person >= 0);
  if (shown.person < 0) return;
  const DepthSummary& person = port_->people()[static_cast<std::size_t>(shown.person)];
  QString text =
      tr("Image %1 of %2, %3").arg(shown.image + 1).arg(person.images).arg(secondsWithUnit(shown.t));
  if (!isOfMoment()) text = tr("%1 (of a moment before)").arg(text);
  if (!shown.found && shown.problem.isEmpty()) text = tr("%1: the body was not found").arg(text);
  caption_->setText(tr("%1\nCamera of %2 pixels; body found in %3 of %4 images")
                        .arg(text, person.camera)
                        .arg(person.found)
                        .arg(person.images));
  caption_->setToolTip(person.reason);
}

void DepthPanel::showLegend() {
  const DepthPicture& shown = view_->picture();
  legend_->setVisible(shown.person >= 0);
  const auto count = [&](JointLook look) {
    return std::count_if(shown.joints.begin(), shown.joints.end(),
                         [look](const DepthJoint& joint) { return joint.look == look; });
  };
  const auto part = [&](JointLook look, QChar sign, const QString& text) {
    QString counted = text.arg(count(look));
    // A mark and its words stay on one line.
    counted.replace(QLatin1Char(' '), QChar(QChar::Nbsp));
    return mark(look, sign) + QChar(QChar::Nbsp) + counted;
  };
  legend_->setText(QStringList{part(JointLook::kTracked, QChar(0x25cf), tr("%1 tracked")),
                               part(JointLook::kInferred, QChar(0x25cb), tr("%1 inferred")),
                               part(JointLook::kUnknown, QChar(0x00d7), tr("%1 not known"))}
                       .join(QStringLiteral(" &nbsp;")));
  QStringList joints{tr("Standard deviation of each joint along its worst axis")};
  for (const DepthJoint& joint : shown.joints) joints << jointText(joint);
  legend_->setToolTip(joints.join(QLatin1Char('\n')));
}

}  // namespace abstand::ui
