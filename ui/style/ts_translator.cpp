#include "ui/style/ts_translator.hpp"

#include <QFile>
#include <QXmlStreamReader>

namespace abstand::ui {

namespace {

QByteArray keyOf(const QByteArray& context, const QByteArray& source, const QByteArray& disambiguation) {
  return context + '\0' + source + '\0' + disambiguation;
}

/// The reader stands at <translation>. Empty: it is not finished.
QStringList readForms(QXmlStreamReader& xml) {
  const bool finished = !xml.attributes().hasAttribute(QLatin1String("type"));
  QStringList forms;
  QString text;
  while (!xml.atEnd() && xml.readNext() != QXmlStreamReader::EndElement) {
    if (xml.isStartElement())
      forms << xml.readElementText();
    else if (xml.isCharacters())
      text += xml.text();
  }
  if (forms.isEmpty()) forms << text;
  if (!finished || forms.contains(QString())) forms.clear();
  return forms;
}

}  // namespace

bool TsTranslator::read(const QString& file) {
  forms_.clear();
  QFile device(file);
  if (!device.open(QIODevice::ReadOnly)) return false;
  QXmlStreamReader xml(&device);
  QByteArray context, source, disambiguation;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText().toUtf8();
    if (xml.name() == QLatin1String("message")) disambiguation.clear();
    if (xml.name() == QLatin1String("source")) source = xml.readElementText().toUtf8();
    if (xml.name() == QLatin1String("comment")) disambiguation = xml.readElementText().toUtf8();
    if (xml.name() != QLatin1String("translation")) continue;
    const QStringList forms = readForms(xml);
    if (!forms.isEmpty()) forms_.insert(keyOf(context, source, disambiguation), forms);
  }
  if (xml.hasError()) forms_.clear();
  return !forms_.isEmpty();
}

QString TsTranslator::translate(const char* context, const char* source, const char* disambiguation,
                                int n) const {
  const QStringList forms = forms_.value(keyOf(context, source, disambiguation));
  if (forms.isEmpty()) return {};
  return n < 0 || n == 1 ? forms.first() : forms.last();
}

}  // namespace abstand::ui
