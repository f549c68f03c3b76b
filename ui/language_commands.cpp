#include "ui/language_commands.hpp"

#include <QActionGroup>
#include <QMainWindow>
#include <QStatusBar>
#include <utility>

#include "ui/style/actions.hpp"
#include "ui/style/language.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

constexpr int kLanguageNoticeMs = 8000;
constexpr std::pair<ActionId, Language> kLanguages[] = {{ActionId::kLanguageSystem, Language::kSystem},
                                                        {ActionId::kLanguageEnglish, Language::kEnglish},
                                                        {ActionId::kLanguageGerman, Language::kGerman}};

}  // namespace

void connectLanguages(QMainWindow& window, const Actions& actions) {
  auto* group = new QActionGroup(&window);
  for (const auto& [id, language] : kLanguages) {
    QAction* action = actions[id];
    action->setActionGroup(group);
    action->setChecked(language == chosenLanguage());
    QObject::connect(action, &QAction::triggered, &window, [&window, language = language] {
      chooseLanguage(language);
      window.statusBar()->showMessage(
          tr("The window will be in this language when the program is started again"), kLanguageNoticeMs);
    });
  }
}

}  // namespace abstand::ui
