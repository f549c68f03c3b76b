// The panels of the window.
#pragma once

namespace abstand::ui {

class BookmarkPanel;
class CyclePanel;
class DepthPanel;
class EventPanel;
class GroupPanel;
class HistoryPanel;
class InspectorPanel;
class LogPanel;
class MarginCurve;
class MarginPanel;
class MarginTools;
class NotePanel;
class PairMatrix;
class PairPanel;
class PlotPanel;
class ReactionPanel;
class RecordingPanel;
class RobotPanel;
class SceneTreePanel;
class SeparationPanel;
class StatusPanel;
class TimelinePanel;

/// Each is owned by its dock, the status panel by the status bar.
struct PanelSet {
  SceneTreePanel* tree{nullptr};
  PairPanel* pairs{nullptr};
  TimelinePanel* timeline{nullptr};
  PlotPanel* plots{nullptr};
  MarginPanel* margins{nullptr};
  MarginTools* margin_tools{nullptr};  ///< holds `margins`
  RobotPanel* robots{nullptr};
  ReactionPanel* reactions{nullptr};
  GroupPanel* groups{nullptr};
  NotePanel* notes{nullptr};
  EventPanel* events{nullptr};
  BookmarkPanel* bookmarks{nullptr};
  RecordingPanel* recordings{nullptr};
  MarginCurve* curve{nullptr};
  CyclePanel* cycles{nullptr};
  DepthPanel* depth{nullptr};
  InspectorPanel* inspector{nullptr};
  PairMatrix* matrix{nullptr};
  SeparationPanel* separation{nullptr};
  LogPanel* log{nullptr};
  HistoryPanel* history{nullptr};
  StatusPanel* status{nullptr};
};

}  // namespace abstand::ui
