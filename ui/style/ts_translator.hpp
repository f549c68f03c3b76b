// Words of another language from a file of Qt Linguist (.ts) as it is.
#pragma once

#include <QHash>
#include <QStringList>
#include <QTranslator>

namespace abstand::ui {

/// A translator that reads the .ts file itself. Qt's own reads compiled files, and the package with their
/// compiler needs a browser and a C++ parser: 260 MB on every machine that builds the program.
class TsTranslator : public QTranslator {
 public:
  using QTranslator::QTranslator;
  /// False where there is no such file, it is no XML, or it has no finished message; then nothing is
  /// translated.
  bool read(const QString& file);
  bool isEmpty() const override { return forms_.isEmpty(); }
  /// `n` below 0: no number of things. One thing has the first form, as in English and German; all other
  /// numbers the second.
  QString translate(const char* context, const char* source, const char* disambiguation = nullptr,
                    int n = -1) const override;

 private:
  QHash<QByteArray, QStringList> forms_;  ///< by context, source and disambiguation, one form or two
};

}  // namespace abstand::ui
