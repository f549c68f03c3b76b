// What is shown about a moment under the pointer.
#pragma once

#include <QString>
#include <functional>

namespace abstand::ui {

/// Makes the tip for a moment (s) from its text: rich text with a picture where one can be made.
using MomentTips = std::function<QString(double t, const QString& text)>;

}  // namespace abstand::ui
