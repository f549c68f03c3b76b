// The margin panel with its search field and menus.
#include "ui/panels/margin_tools.hpp"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/margin_panel.hpp"
#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

QToolButton* menuButton(QWidget* parent, const Actions& actions, const QString& text, const QString& tip,
                        std::initializer_list<ActionId> ids) {
  auto* button = new QToolButton(parent);
  auto* menu = new QMenu(button);
  for (const ActionId id : ids) menu->addAction(actions[id]);
  button->setText(text);
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

MarginTools::MarginTools(MarginPanel* panel, const Actions& actions, QWidget* parent)
    : QWidget(parent), search_{new QLineEdit(this)} {
  search_->setPlaceholderText(tr("Search"));
  search_->setClearButtonEnabled(true);
  search_->setAccessibleName(tr("Search margins by name"));
  search_->setToolTip(tr(
      "Shows only margins of parts, links and groups with this in their names; the slider of a group moves\n"
      "only the margins that are shown"));
  connect(search_, &QLineEdit::textChanged, panel, &MarginPanel::setFilter);
  using Id = ActionId;
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 5, 8, 3);
  row->setSpacing(4);
  row->addWidget(search_, 1);
  row->addWidget(
      menuButton(this, actions, tr("Presets"), tr("Set all margins that are not locked"),
                 {Id::kResetMargins, Id::kNoMargins, Id::kMargins50, Id::kMargins100, Id::kMargins200}));
  row->addWidget(menuButton(this, actions, tr("Sets"), tr("Copy, save, propose and compare margins"),
                            {Id::kCopyMargins, Id::kPasteMargins, Id::kOpenMargins, Id::kSaveMargins,
                             Id::kProposeMargins, Id::kProposeSpeeds, Id::kCompareMargins, Id::kWhatIf}));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(row);
  panel->setFrameShape(QFrame::NoFrame);
  layout->addWidget(panel, 1);
}

}  // namespace abstand::ui
