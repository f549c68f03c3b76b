// What an empty window offers.
#include "ui/panels/start_page.hpp"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

constexpr int kPageWidth = 420;  // px
constexpr int kMaxRecent = 5;

QPushButton* buttonOf(QAction* action, QWidget* parent) {
  auto* button = new QPushButton(action->icon(), action->text().remove(QLatin1Char('&')), parent);
  button->setObjectName(QStringLiteral("start_") + action->objectName());
  button->setToolTip(action->toolTip());
  QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
  return button;
}

}  // namespace

StartPage::StartPage(const Actions& actions, const QString& demonstration, QWidget* parent)
    : QFrame(parent), actions_{actions}, demonstration_{demonstration}, layout_{new QVBoxLayout(this)} {
  setObjectName(QStringLiteral("start_page"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setFixedWidth(kPageWidth);
  setAccessibleName(tr("Start"));
  layout_->setContentsMargins(18, 14, 18, 14);
  auto* title = new QLabel(tr("How near do people come to robots?"), this);
  QFont font = title->font();
  font.setPointSizeF(font.pointSizeF() + 3.0);
  font.setBold(true);
  title->setFont(font);
  title->setWordWrap(true);
  layout_->addWidget(title);
  auto* text =
      new QLabel(tr("Open a project, a scene, a robot or a recording, or drop it on this window."), this);
  text->setWordWrap(true);
  layout_->addWidget(text);
  layout_->addSpacing(4);
  layout_->addWidget(buttonOf(actions[ActionId::kOpenScene], this));
  layout_->addWidget(buttonOf(actions[ActionId::kOpenRecording], this));
  if (!demonstration_.isEmpty()) {
    auto* demo = new QPushButton(tr("Open the demonstration"), this);
    demo->setObjectName(QStringLiteral("start_demonstration"));
    demo->setToolTip(tr("A recorded boxer before a robot with two arms: %1").arg(demonstration_));
    connect(demo, &QPushButton::clicked, this, [this] { Q_EMIT fileWanted(demonstration_); });
    layout_->addWidget(demo);
  }
  layout_->addWidget(buttonOf(actions[ActionId::kTour], this));
  recent_ = new QVBoxLayout;
  recent_->setSpacing(0);
  layout_->addLayout(recent_);
  parent->installEventFilter(this);
  hide();
}

void StartPage::open(const QStringList& recent) {
  while (QLayoutItem* item = recent_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  if (!recent.isEmpty()) recent_->addWidget(new QLabel(tr("Recent files"), this));
  for (const QString& file : recent.mid(0, kMaxRecent)) {
    auto* button = new QPushButton(this);
    button->setFlat(true);
    button->setStyleSheet(QStringLiteral("text-align: left"));
    const QFileInfo info(file);
    button->setText(button->fontMetrics().elidedText(
        tr("%1  (%2)").arg(info.fileName(), QDir::toNativeSeparators(info.absolutePath())), Qt::ElideMiddle,
        kPageWidth - 60));
    button->setToolTip(file);
    connect(button, &QPushButton::clicked, this, [this, file] { Q_EMIT fileWanted(file); });
    recent_->addWidget(button);
  }
  show();
  place();
}

void StartPage::place() {
  adjustSize();
  const QSize room = parentWidget()->size();
  move((room.width() - width()) / 2, std::max(0, (room.height() - height()) / 2));
  raise();
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace abstand::ui
