// Colours of the window, light and dark; the alarm colours are the same in both (Okabe-Ito).
#pragma once

#include <QColor>
#include <QPalette>

class QApplication;

namespace abstand::ui {

inline constexpr QRgb kVermillion = 0xffd55e00;    ///< something touches; always with a mark or a text
inline constexpr QRgb kOchre = 0xffb07a00;         ///< inside a margin, nothing touches; likewise
inline constexpr QRgb kCalm = 0xff5f6b77;          ///< neither near nor touching
inline constexpr QRgb kAmber = 0xffe69f00;         ///< close to the margin
inline constexpr QRgb kContactForce = 0xffc0342b;  ///< force where surfaces overlap
inline constexpr QRgb kVirtualForce = kOchre;      ///< force of the margins alone: nothing touches
inline constexpr QRgb kBlue = 0xff0072b2;          ///< torque
inline constexpr QRgb kViolet = 0xff7a4ea3;        ///< torque or force on a joint
inline constexpr QRgb kCyan = 0xff2aa8c4;          ///< velocity
inline constexpr QRgb kAccent = 0xff3b78b5;        ///< selection

/// A distance below this many margins counts as near.
inline constexpr double kNearFactor = 2.0;

enum class Theme { kLight, kDark };

/// What the viewport and the charts need beside the palette.
struct SceneColours {
  QColor sky_top, sky_bottom, floor, grid, shadow;
  QColor human, objects;
  QColor label_text, label_back;
};

QPalette palette(Theme theme);
/// By the lightness of the window colour, so that a system palette is understood too.
Theme themeOf(const QPalette& palette);
/// Fusion style, palette and the few style rules that the palette cannot say.
void applyTheme(QApplication& app, Theme theme);
SceneColours sceneColours(Theme theme);
/// Colour of the nth mechanism, told apart by lightness as well as by hue.
QColor mechanismColour(int index, Theme theme);

}  // namespace abstand::ui
