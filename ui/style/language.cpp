#include "ui/style/language.hpp"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QSettings>
#include <QTranslator>
#include <array>

#include "ui/style/ts_translator.hpp"

/// The resources of a static library; in no namespace, as the macro demands.
static void initTranslations() { Q_INIT_RESOURCE(translations); }

namespace abstand::ui {

namespace {

const QString kLanguageKey = QStringLiteral("window/language");
const QString kTranslatorName = QStringLiteral("abstand_translator");
constexpr std::array<const char*, 3> kLanguageWords{"system", "en", "de"};

void install(QCoreApplication& app, QTranslator* translator, bool is_read) {
  translator->setObjectName(kTranslatorName);
  translator->setParent(&app);
  if (is_read)
    QCoreApplication::installTranslator(translator);
  else
    delete translator;
}

}  // namespace

QString wordOf(Language language) {
  return QString::fromLatin1(kLanguageWords[static_cast<std::size_t>(language)]);
}

std::optional<Language> languageOf(const QString& word) {
  for (const Language language : {Language::kSystem, Language::kEnglish, Language::kGerman})
    if (word == wordOf(language)) return language;
  return {};
}

Language chosenLanguage() {
  return languageOf(QSettings().value(kLanguageKey).toString()).value_or(Language::kSystem);
}

void chooseLanguage(Language language) { QSettings().setValue(kLanguageKey, wordOf(language)); }

QLocale localeOf(Language language) {
  const QLocale system = QLocale::system();
  const QStringList wanted = system.uiLanguages();
  const bool system_is_german = !wanted.isEmpty() && wanted.first().startsWith(QLatin1String("de"));
  QLocale locale(QLocale::English, QLocale::UnitedKingdom);
  if (language == Language::kGerman || (language == Language::kSystem && system_is_german))
    locale =
        QLocale(QLocale::German, system.language() == QLocale::German ? system.country() : QLocale::Germany);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

void applyLanguage(QCoreApplication& app, Language language) {
  initTranslations();
  qDeleteAll(app.findChildren<QTranslator*>(kTranslatorName, Qt::FindDirectChildrenOnly));
  const QLocale locale = localeOf(language);
  QLocale::setDefault(locale);
  const bool german = locale.language() == QLocale::German;
  if (german) {
    auto* qt = new QTranslator;
    install(app, qt,
            qt->load(QStringLiteral("qtbase_de"), QLibraryInfo::location(QLibraryInfo::TranslationsPath)));
  }
  auto* own = new TsTranslator;
  install(app, own,
          own->read(german ? QStringLiteral(":/translations/abstand_de.ts")
                           : QStringLiteral(":/translations/abstand_en.ts")));
}

}  // namespace abstand::ui
