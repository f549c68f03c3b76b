// Test programs of the window: an application, settings of their own, no wish to touch the user's.
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include "ui/style/language.hpp"
#include "ui/viewport/opengl.hpp"

namespace {
constexpr int kSkipped = 77;  // ctest's return code for a test that could not run
}

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (qEnvironmentVariableIsEmpty("DISPLAY") && qgetenv("QT_QPA_PLATFORM") == "xcb") return kSkipped;
  abstand::ui::prepareOpenGl(true);
  QApplication app(argc, argv);
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  QCoreApplication::setOrganizationName(QStringLiteral("Abstand"));
  QCoreApplication::setApplicationName(QStringLiteral("Test"));
  // Whatever the system speaks.
  abstand::ui::applyLanguage(app, abstand::ui::Language::kEnglish);
  return RUN_ALL_TESTS();
}
