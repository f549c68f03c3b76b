// What the window needs from the analysis of a recording.
#pragma once

#include "core/view/analysis_news.hpp"

namespace abstand::ui {

/// The way to an analysis that runs elsewhere. Called by the GUI thread, which never waits.
class AnalysisPort {
 public:
  virtual ~AnalysisPort() = default;

  /// Moves what is new since the last call to `out`; false, and `out` untouched, for nothing.
  virtual bool takeNews(view::AnalysisNews& out) = 0;
};

}  // namespace abstand::ui
