// Words of free functions in the language of the window.
#pragma once

#include <QCoreApplication>

namespace abstand::ui {

/// Translates a literal in a free function, where lupdate files it under the name of the namespace. Classes
/// with Q_OBJECT have a tr() of their own, which comes first.
inline QString tr(const char* text) { return QCoreApplication::translate("abstand::ui", text); }

}  // namespace abstand::ui
