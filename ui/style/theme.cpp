// Colours of the window, light and dark.
#include "ui/style/theme.hpp"

#include <QApplication>
#include <QStyleFactory>
#include <array>

namespace abstand::ui {

namespace {

struct Shades {
  QRgb window, base, alternate, text, muted, button, line, highlight;
};

constexpr Shades kLightShades{0xfff3f5f7, 0xffffffff, 0xfff7f9fb, 0xff1f2a35,
                              0xff7b8794, 0xffe9edf1, 0xffc9d1d9, 0xff3b78b5};
constexpr Shades kDarkShades{0xff262b32, 0xff1d2126, 0xff22272d, 0xffdde3ea,
                             0xff8a95a1, 0xff323941, 0xff414a54, 0xff4a8ac9};

const Shades& shades(Theme theme) { return theme == Theme::kDark ? kDarkShades : kLightShades; }

const char* const kStyleRules = R"(
QMainWindow::separator { background: palette(window); width: 5px; height: 5px; }
QDockWidget { font-weight: 600; }
QDockWidget::title { background: palette(button); padding: 5px 8px; border-bottom: 1px solid palette(mid); }
QToolBar { border: 0; border-bottom: 1px solid palette(mid); spacing: 2px; padding: 3px 6px; }
QToolBar QToolButton { padding: 4px; border-radius: 4px; border: 1px solid transparent; }
QToolBar QToolButton:hover { background: palette(button); border-color: palette(mid); }
QToolBar QToolButton:checked { background: palette(midlight); border-color: palette(mid); }
QToolButton:checked { background: palette(midlight); border: 1px solid palette(highlight); border-radius: 4px; }
QStatusBar { border-top: 1px solid palette(mid); }
QStatusBar::item { border: 0; }
QHeaderView::section { background: palette(button); border: 0; border-right: 1px solid palette(mid);
  border-bottom: 1px solid palette(mid); padding: 3px 6px; }
QHeaderView::up-arrow, QHeaderView::down-arrow { subcontrol-origin: padding; subcontrol-position: center left;
  left: 3px; width: 9px; height: 9px; }
QAbstractItemView { border: 1px solid palette(mid); }
QScrollArea { border: 0; }
QToolTip { padding: 3px; }
)";

}  // namespace

QPalette palette(Theme theme) {
  const Shades& s = shades(theme);
  QPalette p(QColor(s.button), QColor(s.window));
  p.setColor(QPalette::Base, QColor(s.base));
  p.setColor(QPalette::AlternateBase, QColor(s.alternate));
  p.setColor(QPalette::Window, QColor(s.window));
  p.setColor(QPalette::Button, QColor(s.button));
  p.setColor(QPalette::Mid, QColor(s.line));
  p.setColor(QPalette::Midlight, QColor(s.line).lighter(theme == Theme::kDark ? 115 : 108));
  for (const auto role :
       {QPalette::Text, QPalette::WindowText, QPalette::ButtonText, QPalette::ToolTipText}) {
    p.setColor(role, QColor(s.text));
    p.setColor(QPalette::Disabled, role, QColor(s.muted));
  }
  p.setColor(QPalette::PlaceholderText, QColor(s.muted));
  p.setColor(QPalette::ToolTipBase, QColor(s.base));
  p.setColor(QPalette::Highlight, QColor(s.highlight));
  p.setColor(QPalette::HighlightedText, Qt::white);
  p.setColor(QPalette::Link, QColor(s.highlight));
  return p;
}

Theme themeOf(const QPalette& p) {
  return p.color(QPalette::Window).lightness() < 128 ? Theme::kDark : Theme::kLight;
}

void applyTheme(QApplication& app, Theme theme) {
  app.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  app.setPalette(palette(theme));
  app.setStyleSheet(QString::fromLatin1(kStyleRules));
}

SceneColours sceneColours(Theme theme) {
  if (theme == Theme::kDark)
    return {QColor(0xff2b333d), QColor(0xff4a5562), QColor(0xff56616d),
            QColor(0xff7d8893), QColor(0xff3a434d), QColor(0xff8fb3d1),
            QColor(0xffa3a79c), QColor(0xfff0f3f6), QColor(0xe01d2126)};
  return {QColor(0xffb9c6d4), QColor(0xfff2f5f8), QColor(0xffdde3e9), QColor(0xffaab5c0), QColor(0xffbfc8d1),
          QColor(0xff7fa6c9), QColor(0xffa8aa9c), QColor(0xff1f2a35), QColor(0xf0ffffff)};
}

QColor mechanismColour(int index, Theme theme) {
  // Warm greys and muted oranges; vermillion itself stays for contact.
  static constexpr std::array<QRgb, 5> kLightTones{0xffd9d2c7, 0xffe3b98a, 0xffb9ada0, 0xffcfa58c,
                                                   0xffe6dcc0};
  const auto tone = QColor(kLightTones[static_cast<std::size_t>(index) % kLightTones.size()]);
  return theme == Theme::kDark ? tone.darker(108) : tone;
}

}  // namespace abstand::ui
