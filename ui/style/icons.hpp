// Vector icons in the palette's text colour, drawn when needed, sharp at any scale.
#pragma once

#include <QColor>
#include <QIcon>

namespace abstand::ui {

enum class Glyph {
  kNone,
  kOpen,
  kRecording,
  kCamera,
  kPlay,
  kPause,
  kStepBack,
  kStepForward,
  kBackSecond,
  kForwardSecond,
  kToStart,
  kToEnd,
  kLoop,
  kForce,
  kTorque,
  kVelocity,
  kClosest,
  kLabel,
  kFloor,
  kShadow,
  kReact,
  kBody,
  kFit,
  kIso,
  kFront,
  kSide,
  kTop,
  kTheme,
  kLocked,
  kUnlocked,
  kHelp
};

QIcon icon(Glyph glyph);

/// A square of one colour. Unlike a colour as decoration of an item, it leaves nothing in QPixmapCache when
/// it is drawn.
QIcon swatch(const QColor& colour);

/// Of the program: a person, a robot, and the distance between them.
QIcon programIcon();

}  // namespace abstand::ui
