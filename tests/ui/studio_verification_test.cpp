// "Verify the engine" in the window: the same checks and the same page as `abstand verify`, and stopping.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <nlohmann/json.hpp>

#include "core/base/text_file.hpp"
#include "tests/ui/modal_answer.hpp"
#include "tests/ui/studio_window.hpp"
#include "ui/panels/verification_dialog.hpp"
#include "ui/style/actions.hpp"
#include "ui/verification_commands.hpp"

namespace abstand::studio {
namespace studio_verification_test {

struct StudioVerification : StudioWindow {
  StudioVerification() {
    window.actions()[ui::ActionId::kVerify]->trigger();
    dialog = window.verification().dialog();
    family = dialog->findChild<QComboBox*>("family");
  }
  void click(const char* word) {
    for (QPushButton* button : dialog->findChildren<QPushButton*>())
      if (button->text().remove('&').contains(QLatin1String(word))) return button->click();
    FAIL() << word;
  }
  QString cell(int row, int column) const { return dialog->table()->item(row, column)->text(); }

  ui::VerificationDialog* dialog{nullptr};
  QComboBox* family{nullptr};
};

TEST_F(StudioVerification, ChecksAreThoseOfTheCommandLine) {
  family->setCurrentIndex(family->findData("third law"));
  click("Start");
  EXPECT_TRUE(dialog->waiting());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog->waiting(); }, kLoadMs));
  const auto out = folder.path() / "verify.json", page = folder.path() / "page.html";
  const std::string command = "'" ABSTAND_PROGRAM "' verify --quick --json --only 'third law' --report '" +
                              page.string() + "' >'" + out.string() + "' 2>/dev/null";
  ASSERT_EQ(WEXITSTATUS(std::system(command.c_str())), 0);
  const auto told = nlohmann::json::parse(readFile(out, 1 << 20, true));
  const auto& checks = told["checks"];
  ASSERT_EQ(dialog->table()->rowCount(), static_cast<int>(checks.size()));
  ASSERT_GT(checks.size(), 0u);
  for (int i = 0; i < dialog->table()->rowCount(); ++i) {
    const auto& check = checks[static_cast<std::size_t>(i)];
    EXPECT_EQ(cell(i, 0).toStdString(), check["name"].get<std::string>());
    EXPECT_EQ(cell(i, 1), QStringLiteral("passed"));
    EXPECT_EQ(cell(i, 2), QLocale().toString(check["poses"].get<qulonglong>()));
    EXPECT_EQ(cell(i, 5), QLocale().toString(check["worst"].get<double>(), 'g', 3));
    EXPECT_TRUE(dialog->table()->item(i, 0)->toolTip().contains(
        QString::fromStdString(check["quantity"].get<std::string>())));
  }
  EXPECT_TRUE(dialog->sentence()->text().startsWith("Passed: all "))
      << dialog->sentence()->text().toStdString();

  QCoreApplication::setApplicationVersion(QString::fromStdString(told["version"].get<std::string>()));
  const auto saved = folder.path() / "saved.html";
  const ui::ModalAnswer answer =
      ui::ModalAnswer::choose("verification_page", QString::fromStdString(saved.string()));
  click("Save page");
  EXPECT_EQ(readFile(saved, 1 << 24, true), readFile(page, 1 << 24, true));
}

TEST_F(StudioVerification, StoppedChecksHaveNotPassed) {
  click("Start");
  QTest::qWait(300);
  click("Stop");
  EXPECT_FALSE(dialog->waiting());
  EXPECT_TRUE(dialog->sentence()->text().contains("incomplete"));
  for (QPushButton* button : dialog->findChildren<QPushButton*>())
    EXPECT_FALSE(button->text().contains("page") && button->isEnabled());
  // What was stopped may still be ending: its rows do not mix with others.
  family->setCurrentIndex(family->findData("third law"));
  click("Start");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog->waiting(); }, kLoadMs));
  ASSERT_EQ(dialog->table()->rowCount(), 2);
  EXPECT_EQ(cell(0, 0), QStringLiteral("third_law"));
  EXPECT_EQ(cell(1, 0), QStringLiteral("exchange"));
}

TEST_F(StudioVerification, BrokenLimitIsMarked) {
  click("Start");
  ui::VerificationNews news;
  news.rows.resize(2);
  news.rows[0].name = "bound.mixed";
  news.rows[0].passed = true;
  news.rows[1].name = "third_law";
  news.rows[1].breaches = 3;
  news.ended = true;
  dialog->add(news);
  EXPECT_EQ(cell(1, 1), QStringLiteral("⚠ 3 breaches"));
  EXPECT_EQ(dialog->sentence()->text(), QStringLiteral("Not passed: 1 of 2 checks."));
}

}  // namespace studio_verification_test
}  // namespace abstand::studio
