#include "ui/style/kept_keys.hpp"

#include <QSettings>
#include <algorithm>
#include <optional>

#include "ui/style/actions.hpp"

namespace abstand::ui {

namespace {

const QString kNoKey = QStringLiteral("none");
const QString kKeysGroup = QStringLiteral("keys");

QStringList textsOf(const QList<QKeySequence>& keys) {
  QStringList texts;
  for (const QKeySequence& key : keys) texts << key.toString(QKeySequence::PortableText);
  return texts.isEmpty() ? QStringList{kNoKey} : texts;
}

/// Nothing where there is no text, or one of them is no key.
std::optional<QList<QKeySequence>> keysOf(const QStringList& texts) {
  QList<QKeySequence> keys;
  if (texts.isEmpty()) return {};
  if (texts == QStringList{kNoKey}) return keys;
  for (const QString& text : texts) {
    const QKeySequence key = QKeySequence::fromString(text, QKeySequence::PortableText);
    if (key.isEmpty() || key[0] == Qt::Key_unknown) return {};
    keys << key;
  }
  return keys;
}

bool anyClash(const Actions& actions) {
  return std::any_of(actions.all().begin(), actions.all().end(), [&](const Actions::Entry& entry) {
    const QList<QKeySequence> keys = entry.action->shortcuts();
    return keys != entry.default_keys && std::any_of(keys.begin(), keys.end(), [&](const QKeySequence& key) {
             return actions.ownerOf(key, entry.action) != nullptr;
           });
  });
}

}  // namespace

void saveKeys(const Actions& actions) {
  QSettings settings;
  settings.remove(kKeysGroup);
  settings.beginGroup(kKeysGroup);
  for (const Actions::Entry& entry : actions.all())
    if (entry.action->shortcuts() != entry.default_keys)
      settings.setValue(entry.action->objectName(), textsOf(entry.action->shortcuts()));
}

void loadKeys(const Actions& actions) {
  QSettings settings;
  settings.beginGroup(kKeysGroup);
  for (const Actions::Entry& entry : actions.all()) {
    if (!settings.contains(entry.action->objectName())) continue;
    if (const auto keys = keysOf(settings.value(entry.action->objectName()).toStringList()))
      Actions::setKeys(entry.action, *keys);
  }
  if (anyClash(actions)) resetKeys(actions);
}

void resetKeys(const Actions& actions) {
  for (const Actions::Entry& entry : actions.all()) Actions::setKeys(entry.action, entry.default_keys);
}

}  // namespace abstand::ui
