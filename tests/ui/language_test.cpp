// The window in German: words, numbers, menus; and the plurals of English.
#include <QAbstractItemView>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QStatusBar>
#include <QTemporaryFile>
#include <map>
#include <set>

#include "tests/ui/shown_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/panels/margin_panel.hpp"
#include "ui/panels/margin_row.hpp"
#include "ui/panels/pair_panel.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/style/actions.hpp"
#include "ui/style/format.hpp"
#include "ui/style/language.hpp"
#include "ui/style/number_box.hpp"
#include "ui/style/ts_translator.hpp"

namespace abstand::ui {
namespace language_test {

struct GermanWords {
  GermanWords() { applyLanguage(*qApp, Language::kGerman); }
  ~GermanWords() { applyLanguage(*qApp, Language::kEnglish); }
};

struct GermanWindow : GermanWords, ShownWindow {
  QAction* action(ActionId id) { return window.actions()[id]; }
};

QString withoutMnemonic(QString text) { return text.remove(QLatin1Char('&')); }

/// Of a menu and those in it: no letter twice.
void expectMnemonicsAreUnique(const QWidget& menu) {
  std::map<QChar, QString> owner;
  for (const QAction* action : menu.actions()) {
    if (action->menu()) expectMnemonicsAreUnique(*action->menu());
    const int at = action->text().indexOf(QLatin1Char('&'));
    if (at < 0) continue;
    const auto [other, is_new] = owner.emplace(action->text().at(at + 1).toLower(), action->text());
    EXPECT_TRUE(is_new) << action->text().toStdString() << " and " << other->second.toStdString();
  }
}

/// What a window shows and says, also of what is hidden.
std::set<QString> textsOf(const QWidget& window) {
  std::set<QString> texts;
  const auto take = [&](const QObject* object) {
    for (const char* property :
         {"text", "toolTip", "statusTip", "windowTitle", "accessibleName", "placeholderText", "title"})
      texts.insert(object->property(property).toString());
  };
  for (const auto* widget : window.findChildren<QWidget*>()) take(widget);
  for (const auto* action : window.findChildren<QAction*>()) take(action);
  for (const auto* box : window.findChildren<QComboBox*>())
    for (int i = 0; i < box->count(); ++i) texts.insert(box->itemText(i));
  for (const auto* view : window.findChildren<QAbstractItemView*>())
    for (int i = 0; view->model() && i < view->model()->columnCount(); ++i)
      for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
        texts.insert(view->model()->headerData(i, Qt::Horizontal, role).toString());
  return texts;
}

/// The same in both languages, or not of the program but of Qt or the scene.
bool isNoWord(const QString& text, const FakeSession& session) {
  static const QRegularExpression kWord(QStringLiteral("[A-Za-z]{3}"));
  static const QStringList kKept{"&English", "English", "&Deutsch", "Deutsch", "Close",
                                 "Float",    "JSON",    "YAML",     "rad/s",   "N·m/rad"};
  if (!text.contains(kWord) || kKept.contains(text) || text.startsWith("qt_")) return true;
  for (const auto& group : session.outline().pair_groups)
    if (text == QString::fromStdString(group)) return true;
  for (const auto& object : session.outline().objects)
    if (text.contains(QString::fromStdString(object.group)) ||
        QString::fromStdString(object.name).endsWith(text))
      return true;
  return false;
}

TEST_F(GermanWindow, NoTextEqualsEnglish) {
  std::set<QString> english;
  {
    applyLanguage(*qApp, Language::kEnglish);
    MainWindow other;
    other.setSession(&session);
    english = textsOf(other);
    other.setSession(nullptr);
  }
  applyLanguage(*qApp, Language::kGerman);
  for (const QString& text : textsOf(window))
    EXPECT_TRUE(isNoWord(text, session) || english.count(text) == 0) << text.toStdString();
}

TEST_F(GermanWindow, MenusAndDocksAreGerman) {
  QStringList menus;
  for (const QAction* top : window.menuBar()->actions()) menus << withoutMnemonic(top->text());
  EXPECT_EQ(menus,
            QStringList({"Datei", "Bearbeiten", "Ansicht", "Sicherheitsabstände", "Wiedergabe", "Hilfe"}));
  QStringList docks;
  for (const auto* dock : window.findChildren<QDockWidget*>()) docks << dock->windowTitle();
  for (const char* title : {"Szene", "Paare", "Zeitleiste", "Abstände", "Ereignisse", "Lesezeichen"})
    EXPECT_TRUE(docks.contains(QString::fromUtf8(title))) << title;
  EXPECT_EQ(withoutMnemonic(action(ActionId::kQuit)->text()), "Beenden");
}

TEST_F(GermanWindow, MnemonicsAreUniquePerMenu) { expectMnemonicsAreUnique(*window.menuBar()); }

TEST_F(GermanWindow, NumbersUseCommaAndFilesPoint) {
  EXPECT_EQ(lengthText(1.2345), "1234,5 mm");
  EXPECT_EQ(secondsWithUnit(12.34), "12,340 s");
  ASSERT_TRUE(QTest::qWaitFor(
      [this] {
        for (const QWidget* label : window.findChildren<QWidget*>())
          if (label->property("text").toString().contains("0,000 s")) return true;
        return false;
      },
      kWaitMs));
  const int hand = session.indexOf("operator/hand_left");
  action(ActionId::kMargins50)->trigger();
  ASSERT_TRUE(window.panels().margins->row(hand));
  action(ActionId::kCopyMargins)->trigger();
  const QString set = QApplication::clipboard()->text();
  EXPECT_TRUE(set.contains("margin: 0.05")) << set.toStdString();
}

TEST_F(GermanWindow, TypedTimeAcceptsCommaAndPoint) {
  QLineEdit* go_to = nullptr;
  for (auto* field : window.panels().timeline->findChildren<QLineEdit*>())
    if (field->placeholderText() == "Gehe zu") go_to = field;
  ASSERT_TRUE(go_to);
  for (const char* typed : {"11,5", "11.5"}) {
    window.playback().seek(0.0);
    go_to->setText(typed);
    QTest::keyClick(go_to, Qt::Key_Return);
    EXPECT_EQ(window.playback().time(), 11.5) << typed;
  }
}

TEST_F(GermanWindow, FieldAcceptsPointForComma) {
  NumberBox box;
  box.setRange(0.0, 1000.0);
  box.setDecimals(3);
  box.setSuffix(QStringLiteral(" mm"));
  EXPECT_EQ(box.text(), "0,000 mm");
  for (const char* typed : {"12,5", "12.5"}) {
    box.setValue(0.0);
    box.selectAll();
    QTest::keyClicks(&box, typed);
    box.interpretText();
    EXPECT_EQ(box.value(), 12.5) << typed;
  }
  EXPECT_EQ(box.text(), "12,500 mm");
}

TEST_F(GermanWindow, MenuKeepsChoiceForNextStart) {
  EXPECT_EQ(chosenLanguage(), Language::kSystem);
  EXPECT_TRUE(action(ActionId::kLanguageSystem)->isChecked());
  action(ActionId::kLanguageGerman)->trigger();
  EXPECT_EQ(chosenLanguage(), Language::kGerman);
  EXPECT_FALSE(action(ActionId::kLanguageSystem)->isChecked());
  EXPECT_TRUE(window.statusBar()->currentMessage().contains("neu gestartet"));
  action(ActionId::kLanguageSystem)->trigger();
  EXPECT_EQ(chosenLanguage(), Language::kSystem);
}

TEST_F(GermanWindow, FitsSmallScreen) {
  window.resize(1024, 700);
  EXPECT_EQ(window.size(), QSize(1024, 700));
  EXPECT_LE(window.minimumSizeHint().width(), 1024);
  EXPECT_LE(window.minimumSizeHint().height(), 700);
}

TEST(EnglishWords, SingularAndPluralDiffer) {
  const auto objects = [](int n) {
    return QCoreApplication::translate("abstand::ui::SceneEdits", "%n objects", nullptr, n);
  };
  EXPECT_EQ(objects(1), "1 object");
  EXPECT_EQ(objects(2), "2 objects");
  const GermanWords german;
  EXPECT_EQ(objects(1), "1 Objekt");
  EXPECT_EQ(objects(2), "2 Objekte");
}

TEST(EnglishWords, NumbersUsePoint) {
  EXPECT_EQ(lengthText(1.2345), "1234.5 mm");
  EXPECT_EQ(numberFromText("12,5"), 12.5);
  EXPECT_EQ(numberFromText(" 12.5 "), 12.5);
  for (const char* wrong : {"", "1.000,5", "1,000,5", "nan", "inf", "x"})
    EXPECT_FALSE(numberFromText(wrong)) << wrong;
}

TEST(Languages, HaveDistinctNames) {
  for (const Language language : {Language::kSystem, Language::kEnglish, Language::kGerman})
    EXPECT_EQ(languageOf(wordOf(language)), language);
  EXPECT_FALSE(languageOf("fr"));
  EXPECT_EQ(localeOf(Language::kGerman).decimalPoint(), QLatin1Char(','));
  EXPECT_EQ(localeOf(Language::kEnglish).decimalPoint(), QLatin1Char('.'));
}

/// What a translator reads of a file with this content.
struct TranslatorOf : TsTranslator {
  explicit TranslatorOf(const QByteArray& text) {
    QTemporaryFile file;
    EXPECT_TRUE(file.open());
    file.write(text);
    file.close();
    is_read = read(file.fileName());
  }
  bool is_read{false};
};

TEST(TsTranslator, ReadsFormsEntitiesAndDisambiguation) {
  const TranslatorOf words(
      "<TS><context><name>A</name>"
      "<message><source>a &amp; b</source><translation>A &lt; B</translation></message>"
      "<message numerus='yes'><source>%n</source><translation><numerusform>one</numerusform>"
      "<numerusform>many</numerusform></translation></message>"
      "<message><source>x</source><comment>y</comment><translation>xy</translation></message>"
      "<message><source>x</source><translation>X</translation></message>"
      "<message><source>open</source><translation type='unfinished'>OPEN</translation></message>"
      "<message><source>empty</source><translation></translation></message></context>"
      "<context><name>B</name><message><source>x</source><translation>bx</translation></message></context></"
      "TS>");
  EXPECT_TRUE(words.is_read);
  EXPECT_EQ(words.translate("A", "a & b"), "A < B");
  EXPECT_EQ(words.translate("A", "%n", nullptr, 1), "one");
  for (const int n : {0, 2, 21}) EXPECT_EQ(words.translate("A", "%n", nullptr, n), "many");
  EXPECT_EQ(words.translate("A", "x", "y"), "xy");
  EXPECT_EQ(words.translate("A", "x"), "X");
  EXPECT_EQ(words.translate("B", "x"), "bx");
  for (const char* none : {"open", "empty", "unknown"})
    EXPECT_TRUE(words.translate("A", none).isNull()) << none;
}

TEST(TsTranslator, IsEmptyForUnreadableFile) {
  for (const char* wrong :
       {"", "text", "<TS><context><name>A</name></context></TS>",
        "<TS><context><name>A</name><message><source>x</source><translation>X</translation>"}) {
    const TranslatorOf words(wrong);
    EXPECT_FALSE(words.is_read) << wrong;
    EXPECT_TRUE(words.isEmpty());
    EXPECT_TRUE(words.translate("A", "x").isNull());
  }
  EXPECT_FALSE(TsTranslator().read("/nowhere/abstand_de.ts"));
}

}  // namespace language_test
}  // namespace abstand::ui
