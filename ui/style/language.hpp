// The language of the window, in words and in numbers.
#pragma once

#include <QLocale>
#include <QString>
#include <optional>

class QCoreApplication;

namespace abstand::ui {

enum class Language { kSystem, kEnglish, kGerman };

/// "system", "en" or "de", as --language takes it and the settings keep it.
QString wordOf(Language language);
/// Nothing for another word.
std::optional<Language> languageOf(const QString& word);

/// What the settings keep; that of the system at first.
Language chosenLanguage();
void chooseLanguage(Language language);

/// Of numbers and dates, without separators of groups of digits. A system of a language that the window does
/// not speak counts as English.
QLocale localeOf(Language language);

/// From here on, texts and numbers are in this language: call before windows are made, and after
/// QCoreApplication. GUI thread only.
void applyLanguage(QCoreApplication& app, Language language);

}  // namespace abstand::ui
