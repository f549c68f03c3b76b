#include "app/studio/probe.hpp"

#include <QJsonArray>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "app/studio/probe_figures.hpp"
#include "app/studio/process_usage.hpp"
#include "app/studio/response_probe.hpp"
#include "ui/main_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/model/recording_review.hpp"
#include "ui/viewport/opengl.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::studio {
namespace {

constexpr int kWarmUpMs = 1000;
constexpr int kLookMs = 200;
constexpr int kLongestWaitMs = 120000;

QJsonObject stallsOf(const std::vector<StallWatch::Gap>& gaps) {
  int above_50 = 0, above_100 = 0;
  double longest = 0.0, busiest = 0.0;
  for (const StallWatch::Gap& gap : gaps) {
    above_50 += gap.seconds > 0.05;
    above_100 += gap.seconds > 0.1;
    longest = std::max(longest, gap.seconds);
    busiest = std::max(busiest, gap.processor);
  }
  return {{"above_50_ms", above_50},
          {"above_100_ms", above_100},
          {"longest_ms", rounded(1e3 * longest, 1)},
          {"longest_processor_ms", rounded(1e3 * busiest, 1)}};
}

QJsonArray sizeOf(const QWidget& widget) { return {widget.width(), widget.height()}; }

}  // namespace

Probe::Probe(ui::MainWindow& window, double seconds, QObject* parent)
    : QObject(parent), window_(window), seconds_(seconds) {
  connect(&window_.viewport(), &ui::Viewport::drawn, this, [this](double took) {
    if (done_ && first_picture_ == 0.0) first_picture_ = processAge();
    if (!measuring_) return;
    const double now = 1e-9 * static_cast<double>(wall_.nsecsElapsed());
    if (pictures_++ > 0) intervals_.push_back(now - last_picture_);
    last_picture_ = now;
    renders_.push_back(took);
  });
  connect(&window_, &ui::MainWindow::momentShown, this, [this] {
    if (measuring_) count();
  });
  connect(&window_.review(), &ui::RecordingReview::changed, this, &Probe::watchAnalysis);
}

void Probe::start(std::function<void(const QJsonObject&)> done) {
  done_ = std::move(done);
  watchAnalysis();
  window_.playback().setPlaying(true);
  waitForAnalysis(0);
}

void Probe::watchAnalysis() {
  using State = view::AnalysisNews::State;
  const State state = window_.review().state();
  if (state == State::kRunning && !analysis_.isValid()) analysis_.start();
  if (state == State::kDone && analysis_.isValid() && analysis_s_ == 0.0)
    analysis_s_ = 1e-9 * static_cast<double>(analysis_.nsecsElapsed());
}

void Probe::waitForAnalysis(int waited_ms) {
  using State = view::AnalysisNews::State;
  const ui::RecordingReview& review = window_.review();
  const bool busy = review.available() && review.state() != State::kDone && review.state() != State::kFailed;
  if (busy && waited_ms < kLongestWaitMs) {
    QTimer::singleShot(kLookMs, this, [this, waited_ms] { waitForAnalysis(waited_ms + kLookMs); });
    return;
  }
  opening_ = stalls_.gaps();
  QTimer::singleShot(kWarmUpMs, this, [this] { begin(); });
}

void Probe::begin() {
  resident_ = residentMegabytes();
  processor_ = processorTimes();
  last_t_ = window_.moment().t;
  stalls_.restart();
  wall_.start();
  measuring_ = true;
  QTimer::singleShot(static_cast<int>(1000.0 * seconds_), Qt::PreciseTimer, this, [this] { finish(); });
}

void Probe::count() {
  const view::SceneSnapshot& now = window_.moment();
  if (now.t > last_t_) scene_s_ += now.t - last_t_;
  last_t_ = now.t;
  if (now.step != last_step_) cycles_.push_back(now.cycle_us);
  last_step_ = now.step;
}

QJsonObject Probe::result() const {
  const double wall = 1e-9 * static_cast<double>(wall_.nsecsElapsed());
  const double pictures = std::max(1.0, static_cast<double>(pictures_));
  QJsonObject per_picture, share;
  for (const auto& [name, seconds] : processorTimes()) {
    const auto before = processor_.find(name);
    const double used = seconds - (before == processor_.end() ? 0.0 : before->second);
    if (used < 1e-3 * wall) continue;
    per_picture[QString::fromStdString(name)] = rounded(1e3 * used / pictures);
    share[QString::fromStdString(name)] = rounded(used / wall, 3);
  }
  return {{"renderer", ui::openGlInfo().renderer},
          {"window", sizeOf(window_)},
          {"view", sizeOf(window_.viewport())},
          {"seconds", rounded(wall)},
          {"pictures_per_second", rounded(static_cast<double>(pictures_) / wall)},
          {"render_ms", spread(renders_, 1e3)},
          {"between_pictures_ms", spread(intervals_, 1e3)},
          {"stalls_playing", stallsOf(stalls_.gaps())},
          {"stalls_opening", stallsOf(opening_)},
          {"processor_ms_per_picture", per_picture},
          {"processor_share", share},
          {"real_time_factor", rounded(scene_s_ / wall, 3)},
          {"cycle_us", spread(cycles_, 1.0)},
          {"resident_mb",
           QJsonObject{{"start", rounded(resident_, 1)}, {"end", rounded(residentMegabytes(), 1)}}}};
}

/// Of the whole recording, while it plays; null where it was complete before the first picture.
QJsonObject Probe::analysisFigures() const {
  const double length = window_.playback().end() - window_.playback().start();
  const bool known = analysis_s_ > 0.0;
  return {{"seconds", known ? QJsonValue(rounded(analysis_s_)) : QJsonValue()},
          {"real_time_factor", known ? QJsonValue(rounded(length / analysis_s_, 1)) : QJsonValue()}};
}

void Probe::finish() {
  measuring_ = false;
  QJsonObject figures = result();
  figures["first_picture_s"] = rounded(first_picture_);
  figures["analysis"] = analysisFigures();
  window_.playback().setPlaying(false);
  auto* responses = new ResponseProbe(window_, this);
  responses->start([this, figures](const QJsonObject& response) {
    QJsonObject all = figures;
    all["response"] = response;
    done_(all);
  });
}

}  // namespace abstand::studio
