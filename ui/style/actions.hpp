// Every command of the window in one table: text, tip, shortcut, icon. Menus, toolbars and the shortcut sheet
// come from it.
#pragma once

#include <QAction>
#include <QObject>
#include <array>
#include <vector>

namespace abstand::ui {

enum class ActionId {
  kNew,
  kOpenScene,
  kOpenRecording,
  kOpenDepthFolder,
  kImport,
  kRecordingOptions,
  kReload,
  kConnect,
  kLiveCamera,
  kDisconnect,
  kSaveMoments,
  kRecent1,
  kRecent2,
  kRecent3,
  kRecent4,
  kRecent5,
  kSave,
  kSaveAs,
  kReport,
  kSavePlots,
  kVideo,
  kSaveRange,
  kOpenPairs,
  kSavePairs,
  kScreenshot,
  kCopyPicture,
  kQuit,
  kUndo,
  kRedo,
  kLinkLeft,
  kLinkRight,
  kLinkUp,
  kLinkDown,
  kLinkNearer,
  kLinkFarther,
  kPoke,
  kForces,
  kTorques,
  kJointTorques,
  kVelocities,
  kClosest,
  kLabels,
  kFloor,
  kShadows,
  kTransparent,
  kAutoScale,
  kArrowOptions,
  kLookInside,
  kTreeFiner,
  kTreeCoarser,
  kDepthBody,
  kCloud,
  kCloudConfidence,
  kCloudAll,
  kFront,
  kSide,
  kTop,
  kIso,
  kFit,
  kFitSelection,
  kOrbitLeft,
  kOrbitRight,
  kOrbitUp,
  kOrbitDown,
  kPanLeft,
  kPanRight,
  kPanUp,
  kPanDown,
  kZoomIn,
  kZoomOut,
  kFollowSelection,
  kViewBack,
  kViewForward,
  kClearSelection,
  kPlanSensor,
  kCalibrate,
  kFollowPlots,
  kPinPlot,
  kUnpinPlots,
  kMetres,
  kRadians,
  kClockTime,
  kFindPair,
  kDarkTheme,
  kSystemTheme,
  kFullScreen,
  kResetLayout,
  kLayoutReplay,
  kLayoutTuning,
  kLayoutReview,
  kLanguageSystem,
  kLanguageEnglish,
  kLanguageGerman,
  kPlay,
  kStepForward,
  kStepBack,
  kForwardSecond,
  kBackSecond,
  kToStart,
  kToEnd,
  kToLive,
  kGoToTime,
  kSetIn,
  kSetOut,
  kClearRange,
  kZoomTimeIn,
  kZoomTimeOut,
  kZoomTimeAll,
  kPanTimeBack,
  kPanTimeForward,
  kPauseOnEvent,
  kNextContact,
  kPreviousContact,
  kNextTouch,
  kPreviousTouch,
  kNextIntrusion,
  kPreviousIntrusion,
  kNextNearMiss,
  kPreviousNearMiss,
  kNextStop,
  kPreviousStop,
  kNextLoss,
  kPreviousLoss,
  kAddBookmark,
  kRemoveBookmark,
  kNextBookmark,
  kPreviousBookmark,
  kFaster,
  kSlower,
  kLoop,
  kReact,
  kReactionTorques,
  kResetStops,
  kResetMargins,
  kNoMargins,
  kMargins50,
  kMargins100,
  kMargins200,
  kFindMargin,
  kCopyMargins,
  kPasteMargins,
  kOpenMargins,
  kSaveMargins,
  kProposeMargins,
  kProposeSpeeds,
  kCompareMargins,
  kWhatIf,
  kPalette,
  kShortcuts,
  kEditKeys,
  kTour,
  kVerify,
  kAbout,
  kCount
};

enum class ActionGroup { kFile, kEdit, kView, kMargins, kCamera, kPanels, kPlayback, kHelp };

/// Actions are enabled or not by the owner; what they do is connected by the owner. GUI thread only.
class Actions : public QObject {
  Q_OBJECT

 public:
  explicit Actions(QObject* parent);

  QAction* operator[](ActionId id) const { return actions_[static_cast<std::size_t>(id)]; }
  /// Takes an action that somebody else made and named (a dock's toggle) into the table.
  void adopt(QAction* action, ActionGroup group, const QString& tip, const QKeySequence& key);

  struct Entry {
    QAction* action;  ///< its object name is the same in all languages, and unique
    ActionGroup group;
    QList<QKeySequence> default_keys;
  };
  /// All of them, in the order of the menus.
  const std::vector<Entry>& all() const { return entries_; }
  static QString groupName(ActionGroup group);
  /// The first key stands in the tool tip, too. `action`: of the table.
  static void setKeys(QAction* action, const QList<QKeySequence>& keys);
  /// Another action of the table that has this key, or one that begins with it or that it begins with; null:
  /// none.
  QAction* ownerOf(const QKeySequence& key, const QAction* except) const;

 private:
  void finish(QAction* action, ActionGroup group);

  std::array<QAction*, static_cast<std::size_t>(ActionId::kCount)> actions_{};
  std::vector<Entry> entries_;
};

}  // namespace abstand::ui
