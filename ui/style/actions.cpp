// Every command of the window in one table.
#include "ui/style/actions.hpp"

#include "ui/style/icons.hpp"
#include "ui/style/tr.hpp"

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
#define TEXT(s) QT_TRANSLATE_NOOP("abstand::ui", s)  // scripts/translations knows this name

const Spec kSpecs[] = {
    {Id::kNew, In::kFile, TEXT("&New project"), TEXT("Begin with an empty window"), "Ctrl+N"},
    {Id::kOpenScene, In::kFile, TEXT("&Open…"),
     TEXT("Open projects, scenes, robots, meshes and recordings; several at once become one scene"), "Ctrl+O",
     Kind::kPlain, Glyph::kOpen},
    {Id::kOpenRecording, In::kFile, TEXT("Open &recording…"), TEXT("Let the person move as in a recording"),
     "Ctrl+Shift+O", Kind::kPlain, Glyph::kRecording},
    {Id::kOpenDepthFolder, In::kFile, TEXT("Open depth folder…"),
     TEXT("Let the person move as in the depth images of a folder"), "Ctrl+Alt+H"},
    {Id::kImport, In::kFile, TEXT("Import recording…"),
     TEXT("Open a recording of unknown joints: say which is which, and see the skeleton that comes of it"),
     "Ctrl+Shift+I"},
    {Id::kRecordingOptions, In::kFile, TEXT("Recording op&tions…"),
     TEXT("Say how recordings are understood: units, axis, speed"), "Ctrl+Alt+O"},
    {Id::kReload, In::kFile, TEXT("Re&load"),
     TEXT("Read the scene and its recordings again; margins and view stay"), "Ctrl+R"},
    {Id::kConnect, In::kFile, TEXT("Connect to a running serve…"),
     TEXT("Show what abstand serve computes now, keep the last ten minutes, and go back in them"),
     "Ctrl+Alt+C"},
    {Id::kLiveCamera, In::kFile, TEXT("Open a live depth camera…"),
     TEXT("Let a Kinect at this computer move the person of a scene, and show the distances"),
     "Ctrl+Alt+Shift+L"},
    {Id::kDisconnect, In::kFile, TEXT("Disconnect"),
     TEXT("Show the scene by itself again, without the server"), "Ctrl+Alt+D"},
    {Id::kSaveMoments, In::kFile, TEXT("Save the recording…"),
     TEXT("Save the last ten minutes of the server as a file that this program opens again"), "Ctrl+Alt+E"},
    {Id::kRecent1, In::kFile, TEXT("Recent file 1"), TEXT("Open the file that was opened last"),
     "Ctrl+Alt+1"},
    {Id::kRecent2, In::kFile, TEXT("Recent file 2"), TEXT("Open an earlier file"), "Ctrl+Alt+2"},
    {Id::kRecent3, In::kFile, TEXT("Recent file 3"), TEXT("Open an earlier file"), "Ctrl+Alt+3"},
    {Id::kRecent4, In::kFile, TEXT("Recent file 4"), TEXT("Open an earlier file"), "Ctrl+Alt+4"},
    {Id::kRecent5, In::kFile, TEXT("Recent file 5"), TEXT("Open an earlier file"), "Ctrl+Alt+5"},
    {Id::kSave, In::kFile, TEXT("&Save project"),
     TEXT("Save margins, pairs, visibility, bookmarks and view with the scene and the recording"), "Ctrl+S"},
    {Id::kSaveAs, In::kFile, TEXT("Save project &as…"), TEXT("Save into another project file"), "Ctrl+Alt+S"},
    {Id::kReport, In::kFile, TEXT("Re&port…"),
     TEXT("Make a page of the recording with these margins, to be signed"), "Ctrl+Alt+R"},
    {Id::kSavePlots, In::kFile, TEXT("Sa&ve plots…"), TEXT("Save the plots as a table or a picture"),
     "Ctrl+Alt+P"},
    {Id::kVideo, In::kFile, TEXT("Vi&deo…"), TEXT("Save a video of the 3D view between IN and OUT"),
     "Ctrl+Alt+V"},
    {Id::kSaveRange, In::kFile, TEXT("Save ran&ge as recording…"),
     TEXT("Save the joints between IN and OUT as a recording of its own"), "Ctrl+Alt+I"},
    {Id::kOpenPairs, In::kFile, TEXT("Open pairs (SRDF)…"),
     TEXT("Do not check the pairs of a robot's links that a file disables"), "Ctrl+Alt+U"},
    {Id::kSavePairs, In::kFile, TEXT("Save pairs (SRD&F)…"),
     TEXT("Save which pairs of a robot's links are not checked, for MoveIt"), "Ctrl+Alt+F"},
    {Id::kScreenshot, In::kFile, TEXT("Screens&hot…"), TEXT("Save a picture of the window"), "Ctrl+Shift+S",
     Kind::kPlain, Glyph::kCamera},
    {Id::kCopyPicture, In::kFile, TEXT("&Copy picture"),
     TEXT("Put a picture of the 3D view on the clipboard"), "Ctrl+Shift+C"},
    {Id::kQuit, In::kFile, TEXT("&Quit"), TEXT("Close the window"), "Ctrl+Q"},

    {Id::kUndo, In::kEdit, TEXT("&Undo"), TEXT("Take back the last change"), "Ctrl+Z"},
    {Id::kRedo, In::kEdit, TEXT("&Redo"), TEXT("Redo the last undone change"), "Ctrl+Shift+Z Ctrl+Y"},
    {Id::kLinkLeft, In::kEdit, TEXT("Move link left"),
     TEXT("Pose the robot so that the selected link moves 10 mm to the left of the view; or move a thing"),
     "Alt+Shift+Left"},
    {Id::kLinkRight, In::kEdit, TEXT("Move link right"),
     TEXT("Pose the robot so that the selected link moves 10 mm to the right of the view; or move a thing"),
     "Alt+Shift+Right"},
    {Id::kLinkUp, In::kEdit, TEXT("Move link up"),
     TEXT("Pose the robot so that the selected link moves 10 mm up in the view; or move a thing"),
     "Alt+Shift+Up"},
    {Id::kLinkDown, In::kEdit, TEXT("Move link down"),
     TEXT("Pose the robot so that the selected link moves 10 mm down in the view; or move a thing"),
     "Alt+Shift+Down"},
    {Id::kLinkNearer, In::kEdit, TEXT("Move link nearer"),
     TEXT("Pose the robot so that the selected link moves 10 mm towards the camera; or move a thing"),
     "Alt+Shift+PgUp"},
    {Id::kLinkFarther, In::kEdit, TEXT("Move link farther"),
     TEXT("Pose the robot so that the selected link moves 10 mm away from the camera; or move a thing"),
     "Alt+Shift+PgDown"},
    {Id::kPoke, In::kEdit, TEXT("Poke link"),
     TEXT("Push the selected link away from the camera for half a second"), "Alt+Shift+K"},

    {Id::kForces, In::kView, TEXT("&Forces"),
     TEXT("Show contact forces and virtual (margin) forces as arrows"), "C", Kind::kOn, Glyph::kForce},
    {Id::kTorques, In::kView, TEXT("&Torques"), TEXT("Show torques of contacts and margins as curved arrows"),
     "Shift+C", Kind::kOn, Glyph::kTorque},
    {Id::kJointTorques, In::kView, TEXT("Joint torques"),
     TEXT("Show what contacts and margins cause at each joint, as arrows about or along its axis"), "Alt+C",
     Kind::kOff},
    {Id::kVelocities, In::kView, TEXT("&Velocities"), TEXT("Show velocities as thin arrows"), "V", Kind::kOff,
     Glyph::kVelocity},
    {Id::kClosest, In::kView, TEXT("&Closest points"), TEXT("Show the closest points of the nearest pairs"),
     "D", Kind::kOn, Glyph::kClosest},
    {Id::kLabels, In::kView, TEXT("&Labels"),
     TEXT("Name bodies that touch or are inside a margin, and the selection"), "L", Kind::kOn, Glyph::kLabel},
    {Id::kFloor, In::kView, TEXT("F&loor"), TEXT("Show floor and grid"), "G", Kind::kOn, Glyph::kFloor},
    {Id::kShadows, In::kView, TEXT("&Shadows"), TEXT("Show shadows on the floor"), "Shift+G", Kind::kOn,
     Glyph::kShadow},
    {Id::kTransparent, In::kView, TEXT("Transparent &people"), TEXT("See through body parts"), "T", Kind::kOn,
     Glyph::kBody},
    {Id::kAutoScale, In::kView, TEXT("&Automatic arrow scale"),
     TEXT("Scale arrows to the largest visible force instead of a fixed length per newton"), "A", Kind::kOn},
    {Id::kArrowOptions, In::kView, TEXT("Arrows…"),
     TEXT("Length of arrows, and the least force, torque and speed that are drawn"), "Shift+A"},
    {Id::kLookInside, In::kView, TEXT("Look &inside the selection"),
     TEXT("Shell points, tree spheres, a slice of the distance field, or nothing of the selected bodies"),
     "F6"},
    {Id::kTreeFiner, In::kView, TEXT("Next tree level"), TEXT("Show smaller spheres of the tree"), "F7"},
    {Id::kTreeCoarser, In::kView, TEXT("Tree level before"), TEXT("Show larger spheres of the tree"),
     "Shift+F7"},
    {Id::kDepthBody, In::kView, TEXT("Body over the depth image"),
     TEXT("Draw the fitted body and its joints over the depth image"), "Shift+D", Kind::kOn},
    {Id::kCloud, In::kView, TEXT("Depth points"),
     TEXT("Draw the measured points of the depth images beside the fitted body and the robot"), "K",
     Kind::kOn},
    {Id::kCloudConfidence, In::kView, TEXT("Depth points by confidence"),
     TEXT("Colour the points of a person by the state of the nearest joint instead of by person and robot"),
     "Shift+K", Kind::kOff},
    {Id::kCloudAll, In::kView, TEXT("Depth points of all cameras"),
     TEXT("Draw the points of all cameras instead of those of the person in the panel Depth image"),
     "Ctrl+Shift+K", Kind::kOn},
    {Id::kPlanSensor, In::kView, TEXT("Plan a depth camera…"),
     TEXT("What a depth camera would not see of the people over the whole recording, and why"), "Ctrl+Alt+K"},
    {Id::kCalibrate, In::kView, TEXT("Calibrate a depth camera…"),
     TEXT("Find the pose of a depth camera by the room, a person, a robot, a chessboard or points"),
     "Ctrl+Alt+Shift+K"},
    {Id::kFollowPlots, In::kView, TEXT("Plots f&ollow the time"),
     TEXT("Keep the playhead in the plots' window"), "P", Kind::kOn},
    {Id::kPinPlot, In::kView, TEXT("Keep the selection in the plot"),
     TEXT("The distance plot shows the selected bodies or pair from now on"), "Shift+P"},
    {Id::kUnpinPlots, In::kView, TEXT("Plot the selection only"),
     TEXT("Take from the distance plot what was kept there"), "Ctrl+Shift+P"},
    {Id::kMetres, In::kView, TEXT("Lengths in metres"),
     TEXT("Show lengths in metres instead of millimetres; files keep their units"), "Ctrl+Alt+M", Kind::kOff},
    {Id::kRadians, In::kView, TEXT("Angles in radians"),
     TEXT("Show angles in radians instead of degrees; files keep their units"), "Ctrl+Alt+G", Kind::kOff},
    {Id::kClockTime, In::kView, TEXT("Time of day"),
     TEXT("Show when a moment was recorded, by the clock, instead of the time since the start"),
     "Ctrl+Alt+Shift+T", Kind::kOff},
    {Id::kFindPair, In::kView, TEXT("Fi&nd pair"), TEXT("Go to the filter of the pair table"), "Ctrl+F"},
    {Id::kClearSelection, In::kView, TEXT("Clear &selection"), TEXT("Select nothing"), "Esc"},
    {Id::kDarkTheme, In::kView, TEXT("&Dark theme"), TEXT("Light on dark"), "Ctrl+D", Kind::kOff,
     Glyph::kTheme},
    {Id::kSystemTheme, In::kView, TEXT("Theme of the s&ystem"),
     TEXT("Light or dark as the system was when the program started"), "Ctrl+Shift+D", Kind::kOff},
    {Id::kFullScreen, In::kView, TEXT("F&ull screen"), TEXT("Use the whole screen"), "F11", Kind::kOff},
    {Id::kResetLayout, In::kView, TEXT("&Reset layout"), TEXT("Put all panels where they were at first"),
     "Ctrl+0"},
    {Id::kLayoutReplay, In::kView, TEXT("Layout for repla&y"), TEXT("Scene, timeline and inspector only"),
     "Ctrl+Shift+F2"},
    {Id::kLayoutTuning, In::kView, TEXT("Layout for tuning"),
     TEXT("Margins, margin curve, events and plots around the timeline"), "Ctrl+Shift+F3"},
    {Id::kLayoutReview, In::kView, TEXT("Layout for review"),
     TEXT("Events, reservations and what was read of the recordings"), "Ctrl+Shift+F4"},
    {Id::kLanguageSystem, In::kView, TEXT("&System language"),
     TEXT("Texts and numbers as the system has them, from the next start on"), "Ctrl+Alt+L,S", Kind::kOff},
    {Id::kLanguageEnglish, In::kView, TEXT("&English"),
     TEXT("Texts and numbers in English, from the next start on"), "Ctrl+Alt+L,E", Kind::kOff},
    {Id::kLanguageGerman, In::kView, TEXT("&Deutsch"),
     TEXT("Texts and numbers in German, from the next start on"), "Ctrl+Alt+L,D", Kind::kOff},

    {Id::kFront, In::kCamera, TEXT("&Front"), TEXT("Front view"), "1", Kind::kPlain, Glyph::kFront},
    {Id::kSide, In::kCamera, TEXT("&Side"), TEXT("Side view"), "3", Kind::kPlain, Glyph::kSide},
    {Id::kTop, In::kCamera, TEXT("&Top"), TEXT("View from above"), "7", Kind::kPlain, Glyph::kTop},
    {Id::kIso, In::kCamera, TEXT("&Isometric"), TEXT("View from a corner"), "5", Kind::kPlain, Glyph::kIso},
    {Id::kFit, In::kCamera, TEXT("Fit &all"), TEXT("Zoom to all"), "F", Kind::kPlain, Glyph::kFit},
    {Id::kFitSelection, In::kCamera, TEXT("Fit s&election"), TEXT("Zoom to the selection"), "Shift+F"},
    {Id::kOrbitLeft, In::kCamera, TEXT("Orbit left"), TEXT("Turn the camera about the scene to the left"),
     "Ctrl+Left"},
    {Id::kOrbitRight, In::kCamera, TEXT("Orbit right"), TEXT("Turn the camera about the scene to the right"),
     "Ctrl+Right"},
    {Id::kOrbitUp, In::kCamera, TEXT("Orbit up"), TEXT("Raise the camera"), "Ctrl+Up"},
    {Id::kOrbitDown, In::kCamera, TEXT("Orbit down"), TEXT("Lower the camera"), "Ctrl+Down"},
    {Id::kPanLeft, In::kCamera, TEXT("Pan left"), TEXT("Move the camera to the left"), "Ctrl+Shift+Left"},
    {Id::kPanRight, In::kCamera, TEXT("Pan right"), TEXT("Move the camera to the right"), "Ctrl+Shift+Right"},
    {Id::kPanUp, In::kCamera, TEXT("Pan up"), TEXT("Move the camera up"), "Ctrl+Shift+Up"},
    {Id::kPanDown, In::kCamera, TEXT("Pan down"), TEXT("Move the camera down"), "Ctrl+Shift+Down"},
    {Id::kZoomIn, In::kCamera, TEXT("Zoom in"), TEXT("Move the camera nearer"), "Ctrl++ Ctrl+="},
    {Id::kZoomOut, In::kCamera, TEXT("Zoom out"), TEXT("Move the camera away"), "Ctrl+-"},
    {Id::kFollowSelection, In::kCamera, TEXT("Fo&llow the selection"),
     TEXT("Let the camera move with the selected bodies"), "Ctrl+Shift+F", Kind::kOff},
    {Id::kViewBack, In::kCamera, TEXT("View &before"), TEXT("Put the camera where it was before it moved"),
     "Alt+Left"},
    {Id::kViewForward, In::kCamera, TEXT("View after"), TEXT("Take back the step to the view before"),
     "Alt+Right"},

    {Id::kResetMargins, In::kMargins, TEXT("&As in the scene"),
     TEXT("All safety margins as in the scene file"), "Ctrl+Shift+R"},
    {Id::kNoMargins, In::kMargins, TEXT("&None (0 mm)"), TEXT("All margins 0"), "Ctrl+M,0"},
    {Id::kMargins50, In::kMargins, TEXT("All &50 mm"),
     TEXT("All margins 50 mm; that of a pair is the sum of two"), "Ctrl+M,1"},
    {Id::kMargins100, In::kMargins, TEXT("All &100 mm"),
     TEXT("All margins 100 mm; that of a pair is the sum of two"), "Ctrl+M,2"},
    {Id::kMargins200, In::kMargins, TEXT("All &200 mm"),
     TEXT("All margins 200 mm; that of a pair is the sum of two"), "Ctrl+M,3"},
    {Id::kFindMargin, In::kMargins, TEXT("&Find margin"), TEXT("Go to the search field of the margins"),
     "Ctrl+M,F"},
    {Id::kCopyMargins, In::kMargins, TEXT("&Copy margins"),
     TEXT("Put the margins of people and robots on the clipboard, as a set that abstand tune reads"),
     "Ctrl+M,C"},
    {Id::kPasteMargins, In::kMargins, TEXT("&Paste margins"),
     TEXT("Take the set of margins that is on the clipboard"), "Ctrl+M,V"},
    {Id::kOpenMargins, In::kMargins, TEXT("&Open margins…"),
     TEXT("Take a set of margins from a file of abstand tune --margin-set"), "Ctrl+M,O"},
    {Id::kSaveMargins, In::kMargins, TEXT("&Save margins…"),
     TEXT("Save the margins of people and robots as a set for abstand tune --margin-set"), "Ctrl+M,S"},
    {Id::kProposeMargins, In::kMargins, TEXT("P&ropose margins…"),
     TEXT("The smallest margins without a missed stop in this recording"), "Ctrl+M,P"},
    {Id::kProposeSpeeds, In::kMargins, TEXT("Propose sp&eeds…"),
     TEXT("How fast the robots' program may be in each of its segments, so that no limit is broken"),
     "Ctrl+M,E"},
    {Id::kCompareMargins, In::kMargins, TEXT("Co&mpare with these margins"),
     TEXT("Keep the present margins, and show in the timeline what later ones do differently"), "Ctrl+M,B",
     Kind::kOff},
    {Id::kWhatIf, In::kMargins, TEXT("What-&if assumptions…"),
     TEXT("Reaction time, braking, limit and errors that lanes, events and report are judged with"),
     "Ctrl+M,W"},

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
    {Id::kToLive, In::kPlayback, TEXT("Back to live"),
     TEXT("Show what the server computes now, after a look at what was"), "Ctrl+End"},
    {Id::kGoToTime, In::kPlayback, TEXT("&Go to time…"), TEXT("Type a time or a frame to go to"), "Ctrl+G"},
    {Id::kNextContact, In::kPlayback, TEXT("&Next event"),
     TEXT("Go to the next event of the kinds that the events panel shows"), "N"},
    {Id::kPreviousContact, In::kPlayback, TEXT("Pre&vious event"),
     TEXT("Go to the event before, of the kinds that the events panel shows"), "Shift+N"},
    {Id::kNextTouch, In::kPlayback, TEXT("Next &touch"), TEXT("Go to where a robot next touches a person"),
     "X"},
    {Id::kPreviousTouch, In::kPlayback, TEXT("Touch before"), TEXT("Go to the touch before"), "Shift+X"},
    {Id::kNextIntrusion, In::kPlayback, TEXT("Next &intrusion"), TEXT("Go to where a margin is next broken"),
     "E"},
    {Id::kPreviousIntrusion, In::kPlayback, TEXT("Intrusion before"),
     TEXT("Go to the intrusion into a margin before"), "Shift+E"},
    {Id::kNextNearMiss, In::kPlayback, TEXT("Next &near miss"), TEXT("Go to the next near miss"), "M"},
    {Id::kPreviousNearMiss, In::kPlayback, TEXT("Near miss before"), TEXT("Go to the near miss before"),
     "Shift+M"},
    {Id::kNextStop, In::kPlayback, TEXT("Next &stop"),
     TEXT("Go to where a robot next stopped, as far as it was played"), "S"},
    {Id::kPreviousStop, In::kPlayback, TEXT("Stop before"), TEXT("Go to the stop of a robot before"),
     "Shift+S"},
    {Id::kNextLoss, In::kPlayback, TEXT("Next &loss of tracking"),
     TEXT("Go to where body parts are next not seen"), "U"},
    {Id::kPreviousLoss, In::kPlayback, TEXT("Loss of tracking before"),
     TEXT("Go to the loss of tracking before"), "Shift+U"},
    {Id::kPauseOnEvent, In::kPlayback, TEXT("Pause at e&vents"),
     TEXT("Pause where an event of a shown kind begins, or a near miss is nearest"), "Ctrl+E", Kind::kOff},
    {Id::kSetIn, In::kPlayback, TEXT("Set &IN"), TEXT("The chosen range begins at this moment"), "I"},
    {Id::kSetOut, In::kPlayback, TEXT("Set &OUT"), TEXT("The chosen range ends at this moment"), "O"},
    {Id::kClearRange, In::kPlayback, TEXT("&Clear IN and OUT"), TEXT("Choose the whole recording"),
     "Shift+I"},
    {Id::kZoomTimeIn, In::kPlayback, TEXT("Zoom time in"),
     TEXT("Show less time in the lanes, around this moment (Ctrl and the wheel over them)"), "Alt+= Alt++"},
    {Id::kZoomTimeOut, In::kPlayback, TEXT("Zoom time out"), TEXT("Show more time in the lanes"), "Alt+-"},
    {Id::kZoomTimeAll, In::kPlayback, TEXT("Show all time"), TEXT("Show the whole recording in the lanes"),
     "Ctrl+Backspace"},
    {Id::kPanTimeBack, In::kPlayback, TEXT("Earlier time in the lanes"),
     TEXT("Move what the zoomed lanes show to an earlier time"), "Alt+PgUp"},
    {Id::kPanTimeForward, In::kPlayback, TEXT("Later time in the lanes"),
     TEXT("Move what the zoomed lanes show to a later time"), "Alt+PgDown"},
    {Id::kAddBookmark, In::kPlayback, TEXT("Add &bookmark…"),
     TEXT("Remember this moment with its view and a note"), "Ctrl+B"},
    {Id::kRemoveBookmark, In::kPlayback, TEXT("Remove bookmark"), TEXT("Remove the bookmark at this frame"),
     "Ctrl+Shift+B"},
    {Id::kNextBookmark, In::kPlayback, TEXT("Next bookmark"), TEXT("Go to the next bookmark and its view"),
     "B"},
    {Id::kPreviousBookmark, In::kPlayback, TEXT("Previous bookmark"),
     TEXT("Go to the bookmark before and its view"), "Shift+B"},
    {Id::kFaster, In::kPlayback, TEXT("Fas&ter"), TEXT("The next higher speed"), "= +"},
    {Id::kSlower, In::kPlayback, TEXT("S&lower"), TEXT("The next lower speed"), "-"},
    {Id::kLoop, In::kPlayback, TEXT("Loo&p"), TEXT("Begin again at the end, or at IN when OUT is reached"),
     "Ctrl+L", Kind::kOff, Glyph::kLoop},
    {Id::kReact, In::kPlayback, TEXT("&React"),
     TEXT("Let robots with a reaction react to people; off: they follow their planned motion"), "R",
     Kind::kOn, Glyph::kReact},
    {Id::kReactionTorques, In::kPlayback, TEXT("Reaction &torques"),
     TEXT("Give the torques of the reactions to the robots' motors; off: they only follow and stop"),
     "Shift+T", Kind::kOn},
    {Id::kResetStops, In::kPlayback, TEXT("Reset protective st&ops"),
     TEXT("Let every robot that waits for a reset go on"), "Shift+R"},

    {Id::kPalette, In::kHelp, TEXT("&Find a command…"), TEXT("Find a command by its words, and run it"),
     "Ctrl+K"},
    {Id::kShortcuts, In::kHelp, TEXT("&Shortcuts"), TEXT("All keys on one page"), "F1", Kind::kPlain,
     Glyph::kHelp},
    {Id::kEditKeys, In::kHelp, TEXT("Change &keys…"), TEXT("Give commands other keys"), "Ctrl+F1"},
    {Id::kTour, In::kHelp, TEXT("&Tour of the window"), TEXT("What is where, in a minute"), "Ctrl+Shift+F1"},
    {Id::kVerify, In::kHelp, TEXT("&Verify the engine…"),
     TEXT("Check distances and forces of this machine against brute force and closed forms"), "Ctrl+Alt+Q"},
    {Id::kAbout, In::kHelp, TEXT("&About Abstand"), TEXT("What this program is, and what it is not"),
     "Shift+F1"},
};
#undef TEXT

/// "Save project &as…": "save_project_as".
QString nameOf(const char* text) {
  QString name = QString::fromUtf8(text).toLower().replace(QLatin1Char(' '), QLatin1Char('_'));
  return name.remove(QLatin1Char('&')).remove(QChar(0x2026));
}

}  // namespace

Actions::Actions(QObject* parent) : QObject(parent) {
  for (const Spec& spec : kSpecs) {
    auto* action = new QAction(icon(spec.glyph), ui::tr(spec.text), this);
    action->setToolTip(ui::tr(spec.tip));
    QList<QKeySequence> keys;
    for (const QString& key : QString::fromLatin1(spec.keys).split(QLatin1Char(' ')))
      keys << QKeySequence(key);
    action->setObjectName(nameOf(spec.text));
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
  entries_.push_back({action, group, action->shortcuts()});
  setKeys(action, action->shortcuts());
}

void Actions::setKeys(QAction* action, const QList<QKeySequence>& keys) {
  action->setShortcuts(keys);
  const QString tip = action->statusTip();
  action->setToolTip(
      keys.isEmpty() ? tip : tr("%1 (%2)").arg(tip, keys.first().toString(QKeySequence::NativeText)));
}

QAction* Actions::ownerOf(const QKeySequence& key, const QAction* except) const {
  for (const Entry& entry : entries_) {
    if (entry.action == except) continue;
    for (const QKeySequence& own : entry.action->shortcuts())
      if (own.matches(key) != QKeySequence::NoMatch || key.matches(own) != QKeySequence::NoMatch)
        return entry.action;
  }
  return nullptr;
}

QString Actions::groupName(ActionGroup group) {
  switch (group) {
    case ActionGroup::kFile:
      return tr("&File");
    case ActionGroup::kEdit:
      return tr("&Edit");
    case ActionGroup::kView:
      return tr("&View");
    case ActionGroup::kMargins:
      return tr("&Margins");
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
