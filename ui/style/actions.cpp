// Every command of the window in one table.
#include "ui/style/actions.hpp"

#include "ui/style/icons.hpp"

namespace abstand::ui {

namespace {

enum class Kind { kPlain, kOff, kOn };  // plain, or checkable and off or on at first

struct Spec {
  ActionId id;
  ActionGroup group;
  const char* text;
  const char* tip;
  const char* keys;  // several, parted by blanks
  Kind kind{Kind::kPlain};
  Glyph glyph{Glyph::kNone};
};

using Id = ActionId;
using In = ActionGroup;
#define TEXT(s) QT_TRANSLATE_NOOP("abstand::ui::Actions", s)

const Spec kSpecs[] = {
    {Id::kOpenScene, In::kFile, TEXT("&Open scene…"), TEXT("Open a scene file"), "Ctrl+O", Kind::kPlain,
     Glyph::kOpen},
    {Id::kOpenRecording, In::kFile, TEXT("Open &recording…"), TEXT("Let the person move as in a recording"),
     "Ctrl+Shift+O", Kind::kPlain, Glyph::kRecording},
    {Id::kRecent1, In::kFile, TEXT("Recent scene 1"), TEXT("Open the scene that was opened last"),
     "Ctrl+Alt+1"},
    {Id::kRecent2, In::kFile, TEXT("Recent scene 2"), TEXT("Open an earlier scene"), "Ctrl+Alt+2"},
    {Id::kRecent3, In::kFile, TEXT("Recent scene 3"), TEXT("Open an earlier scene"), "Ctrl+Alt+3"},
    {Id::kRecent4, In::kFile, TEXT("Recent scene 4"), TEXT("Open an earlier scene"), "Ctrl+Alt+4"},
    {Id::kRecent5, In::kFile, TEXT("Recent scene 5"), TEXT("Open an earlier scene"), "Ctrl+Alt+5"},
    {Id::kScreenshot, In::kFile, TEXT("&Screenshot…"), TEXT("Save a picture of the window"), "Ctrl+Shift+S",
     Kind::kPlain, Glyph::kCamera},
    {Id::kCopyPicture, In::kFile, TEXT("&Copy picture"),
     TEXT("Put a picture of the 3D view on the clipboard"), "Ctrl+Shift+C"},
    {Id::kQuit, In::kFile, TEXT("&Quit"), TEXT("Close the window"), "Ctrl+Q"},

    {Id::kForces, In::kView, TEXT("&Forces"), TEXT("Show contact forces as arrows"), "C", Kind::kOn,
     Glyph::kForce},
    {Id::kTorques, In::kView, TEXT("&Torques"), TEXT("Show contact torques as curved arrows"), "Shift+C",
     Kind::kOn, Glyph::kTorque},
    {Id::kVelocities, In::kView, TEXT("&Velocities"), TEXT("Show velocities as thin arrows"), "V", Kind::kOff,
     Glyph::kVelocity},
    {Id::kClosest, In::kView, TEXT("&Closest points"), TEXT("Show the closest points of the nearest pairs"),
     "D", Kind::kOn, Glyph::kClosest},
    {Id::kLabels, In::kView, TEXT("&Labels"), TEXT("Name what is in contact or chosen"), "L", Kind::kOn,
     Glyph::kLabel},
    {Id::kFloor, In::kView, TEXT("F&loor"), TEXT("Show floor and grid"), "G", Kind::kOn, Glyph::kFloor},
    {Id::kShadows, In::kView, TEXT("&Shadows"), TEXT("Show shadows on the floor"), "Shift+G", Kind::kOn,
     Glyph::kShadow},
    {Id::kTransparent, In::kView, TEXT("Transparent &people"), TEXT("See through body parts"), "T", Kind::kOn,
     Glyph::kBody},
    {Id::kAutoScale, In::kView, TEXT("&Automatic arrow scale"),
     TEXT("Scale arrows to the largest force in sight instead of a fixed length per newton"), "A", Kind::kOn},
    {Id::kFollowPlots, In::kView, TEXT("Plots f&ollow the time"),
     TEXT("Keep the playhead in the plots' window"), "P", Kind::kOn},
    {Id::kResetMargins, In::kView, TEXT("Reset &margins"),
     TEXT("All safety margins as when the scene was opened"), "Ctrl+Shift+R"},
    {Id::kFindPair, In::kView, TEXT("Fi&nd pair"), TEXT("Go to the filter of the pair table"), "Ctrl+F"},
    {Id::kClearSelection, In::kView, TEXT("Clear &selection"), TEXT("Choose nothing"), "Esc"},
    {Id::kDarkTheme, In::kView, TEXT("&Dark theme"), TEXT("Light on dark"), "Ctrl+D", Kind::kOff,
     Glyph::kTheme},
    {Id::kFullScreen, In::kView, TEXT("F&ull screen"), TEXT("Use the whole screen"), "F11", Kind::kOff},
    {Id::kResetLayout, In::kView, TEXT("&Reset layout"), TEXT("Put all panels where they were at first"),
     "Ctrl+0"},

    {Id::kFront, In::kCamera, TEXT("&Front"), TEXT("Look along −x"), "1", Kind::kPlain, Glyph::kFront},
    {Id::kSide, In::kCamera, TEXT("&Side"), TEXT("Look along y"), "3", Kind::kPlain, Glyph::kSide},
    {Id::kTop, In::kCamera, TEXT("&Top"), TEXT("Look down"), "7", Kind::kPlain, Glyph::kTop},
    {Id::kIso, In::kCamera, TEXT("&Isometric"), TEXT("Look from a corner"), "5", Kind::kPlain, Glyph::kIso},
    {Id::kFit, In::kCamera, TEXT("Fit &all"), TEXT("Bring everything into sight"), "F", Kind::kPlain,
     Glyph::kFit},
    {Id::kFitSelection, In::kCamera, TEXT("Fit s&election"), TEXT("Bring what is chosen into sight"),
     "Shift+F"},

    {Id::kPlay, In::kPlayback, TEXT("&Play"), TEXT("Play or pause"), "Space", Kind::kPlain, Glyph::kPlay},
    {Id::kStepBack, In::kPlayback, TEXT("Frame &back"), TEXT("One frame back"), "Left", Kind::kPlain,
     Glyph::kStepBack},
    {Id::kStepForward, In::kPlayback, TEXT("Frame &forward"), TEXT("One frame forward"), "Right",
     Kind::kPlain, Glyph::kStepForward},
    {Id::kBackSecond, In::kPlayback, TEXT("Second b&ack"), TEXT("One second back"), "Shift+Left",
     Kind::kPlain, Glyph::kBackSecond},
    {Id::kForwardSecond, In::kPlayback, TEXT("Second f&orward"), TEXT("One second forward"), "Shift+Right",
     Kind::kPlain, Glyph::kForwardSecond},
    {Id::kToStart, In::kPlayback, TEXT("To the &start"), TEXT("Go to the first frame"), "Home", Kind::kPlain,
     Glyph::kToStart},
    {Id::kToEnd, In::kPlayback, TEXT("To the &end"), TEXT("Go to the last frame"), "End", Kind::kPlain,
     Glyph::kToEnd},
    {Id::kGoToTime, In::kPlayback, TEXT("&Go to time…"), TEXT("Type a time or a frame to go to"), "Ctrl+G"},
    {Id::kNextContact, In::kPlayback, TEXT("&Next event"),
     TEXT("Go to the next intrusion into a margin or near miss"), "N"},
    {Id::kPreviousContact, In::kPlayback, TEXT("Pre&vious event"),
     TEXT("Go to the intrusion or near miss before"), "Shift+N"},
    {Id::kPauseOnEvent, In::kPlayback, TEXT("Pause at e&vents"),
     TEXT("Pause where an intrusion begins or a near miss is nearest"), "Ctrl+E", Kind::kOff},
    {Id::kSetIn, In::kPlayback, TEXT("Set &IN"), TEXT("The chosen range begins at this moment"), "I"},
    {Id::kSetOut, In::kPlayback, TEXT("Set &OUT"), TEXT("The chosen range ends at this moment"), "O"},
    {Id::kClearRange, In::kPlayback, TEXT("&Clear IN and OUT"), TEXT("Choose the whole recording"),
     "Shift+I"},
    {Id::kAddBookmark, In::kPlayback, TEXT("Add &bookmark"),
     TEXT("Keep this moment in the list of bookmarks"), "M"},
    {Id::kZoomTimeIn, In::kPlayback, TEXT("Zoom time in"),
     TEXT("Show less time in the lanes, around this moment (Ctrl and the wheel over them)"), "Ctrl+= Ctrl++"},
    {Id::kZoomTimeOut, In::kPlayback, TEXT("Zoom time out"), TEXT("Show more time in the lanes"), "Ctrl+-"},
    {Id::kZoomTimeAll, In::kPlayback, TEXT("Show all time"), TEXT("Show the whole recording in the lanes"),
     "Ctrl+Backspace"},
    {Id::kFaster, In::kPlayback, TEXT("Fas&ter"), TEXT("The next higher speed"), "= +"},
    {Id::kSlower, In::kPlayback, TEXT("S&lower"), TEXT("The next lower speed"), "-"},
    {Id::kLoop, In::kPlayback, TEXT("Loo&p"), TEXT("Begin again at the end, or at IN when OUT is reached"),
     "Ctrl+L", Kind::kOff, Glyph::kLoop},
    {Id::kReact, In::kPlayback, TEXT("&React"),
     TEXT("Let robots with a reaction move away from people; off: they follow their motion"), "R", Kind::kOn,
     Glyph::kReact},
    {Id::kReactionTorques, In::kPlayback, TEXT("Reaction &torques"),
     TEXT("Give the torques of the reactions to the robots' motors; off: they only follow and stop"),
     "Shift+T", Kind::kOn},
    {Id::kResetStops, In::kPlayback, TEXT("Reset st&ops"), TEXT("Let every robot that waits for it go on"),
     "Shift+R"},

    {Id::kShortcuts, In::kHelp, TEXT("&Shortcuts"), TEXT("All keys on one page"), "F1", Kind::kPlain,
     Glyph::kHelp},
    {Id::kAbout, In::kHelp, TEXT("&About Abstand"), TEXT("What this program is, and what it is not"),
     "Shift+F1"},
};
#undef TEXT

}  // namespace

Actions::Actions(QObject* parent) : QObject(parent) {
  for (const Spec& spec : kSpecs) {
    auto* action = new QAction(icon(spec.glyph), tr(spec.text), this);
    action->setToolTip(tr(spec.tip));
    QList<QKeySequence> keys;
    for (const QString& key : QString::fromLatin1(spec.keys).split(QLatin1Char(' ')))
      keys << QKeySequence(key);
    action->setShortcuts(keys);
    action->setCheckable(spec.kind != Kind::kPlain);
    action->setChecked(spec.kind == Kind::kOn);
    action->setIconVisibleInMenu(false);
    actions_[static_cast<std::size_t>(spec.id)] = action;
    finish(action, spec.group);
  }
}

void Actions::adopt(QAction* action, ActionGroup group, const QString& tip, const QKeySequence& key) {
  action->setToolTip(tip);
  action->setShortcut(key);
  finish(action, group);
}

void Actions::finish(QAction* action, ActionGroup group) {
  action->setStatusTip(action->toolTip());
  action->setToolTip(
      tr("%1 (%2)").arg(action->toolTip(), action->shortcut().toString(QKeySequence::NativeText)));
  entries_.push_back({action, group});
}

QString Actions::groupName(ActionGroup group) {
  switch (group) {
    case ActionGroup::kFile:
      return tr("&File");
    case ActionGroup::kView:
      return tr("&View");
    case ActionGroup::kCamera:
      return tr("&Camera");
    case ActionGroup::kPanels:
      return tr("Pan&els");
    case ActionGroup::kPlayback:
      return tr("&Playback");
    case ActionGroup::kHelp:
      return tr("&Help");
  }
  return {};
}

}  // namespace abstand::ui
