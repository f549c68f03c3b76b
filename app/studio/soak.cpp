#include "app/studio/soak.hpp"

#include <QAction>
#include <QJsonArray>
#include <QTimer>
#include <array>
#include <cmath>
#include <numeric>

#include "app/studio/probe_figures.hpp"
#include "app/studio/process_usage.hpp"
#include "ui/main_window.hpp"
#include "ui/model/playback.hpp"
#include "ui/style/actions.hpp"
#include "ui/viewport/viewport.hpp"

namespace abstand::studio {
namespace {

using Id = ui::ActionId;

constexpr int kActionMs = 125;  // an hour then has the commands of eight hours with one each second
constexpr int kSamples = 120;   // over the whole time
constexpr double kFilling = 600.0, kFillingShare = 0.1;  // s, and of a short time: caches fill up in it
constexpr long kActionsPerOpening =
    97;  // no multiple of the round below: the scene opens anew at each of its steps
constexpr double kGolden = 0.6180339887498949;  // multiples of it are spread evenly
constexpr double kSecondsPerHour = 3600.0;

/// One round of work. Each change of the document is undone within it, so that the history does not grow.
constexpr std::array kRound{Id::kForces,       Id::kTorques,      Id::kNextContact,   Id::kMargins50,
                            Id::kUndo,         Id::kIso,          Id::kNextNearMiss,  Id::kMargins200,
                            Id::kUndo,         Id::kLabels,       Id::kFront,         Id::kTransparent,
                            Id::kLayoutTuning, Id::kZoomTimeIn,   Id::kStepBack,      Id::kZoomTimeAll,
                            Id::kLayoutReview, Id::kDarkTheme,    Id::kOrbitLeft,     Id::kFit,
                            Id::kCloud,        Id::kLayoutReplay, Id::kLookInside,    Id::kResetLayout,
                            Id::kNextStop,     Id::kVelocities,   Id::kClearSelection};

QJsonArray pointOf(double t, double resident, double allocated) {
  return {rounded(t, 0), rounded(resident, 1), rounded(allocated, 1)};
}

/// Slope of the least-squares line through the points (x, y); 0 for fewer than two x.
double slopeOf(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0, xy = 0.0;
  for (size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  return xx > 0.0 ? xy / xx : 0.0;
}

}  // namespace

Soak::Soak(ui::MainWindow& window, double seconds, QObject* parent)
    : QObject(parent), window_(window), seconds_(seconds) {
  connect(&window_.viewport(), &ui::Viewport::drawn, this, [this] { ++pictures_; });
}

void Soak::start(std::function<void(const QJsonObject&)> done) {
  ++opened_;
  if (done_) return;  // the scene was opened anew
  done_ = std::move(done);
  wall_.start();
  window_.playback().setPlaying(true);
  auto* acting = new QTimer(this);
  connect(acting, &QTimer::timeout, this, &Soak::act);
  acting->start(kActionMs);
  auto* measuring = new QTimer(this);
  connect(measuring, &QTimer::timeout, this, &Soak::measure);
  measuring->start(static_cast<int>(1000.0 * seconds_ / kSamples));
}

void Soak::act() {
  const ui::Playback& clock = window_.playback();
  if (!clock.playing()) window_.playback().setPlaying(true);
  if (++acted_ % kActionsPerOpening == 0) return window_.actions()[Id::kReload]->trigger();
  if (acted_ % 2 == 0) {
    const double share = std::fmod(kGolden * static_cast<double>(acted_), 1.0);
    return window_.playback().seek(clock.start() + share * (clock.end() - clock.start()));
  }
  QAction* action = window_.actions()[kRound[static_cast<size_t>(acted_ / 2) % kRound.size()]];
  if (action->isEnabled()) action->trigger();
}

void Soak::measure() {
  const double t = 1e-9 * static_cast<double>(wall_.nsecsElapsed());
  samples_.push_back({t, residentMegabytes(), allocatedMegabytes()});
  if (t < seconds_ * (1.0 - 0.5 / kSamples)) return;
  for (QTimer* timer : findChildren<QTimer*>()) timer->stop();
  done_(result());
}

QJsonObject Soak::result() const {
  QJsonArray over_time;
  std::vector<double> t, resident, allocated;
  for (const Sample& s : samples_) {
    over_time.append(pointOf(s.t, s.resident, s.allocated));
    if (s.t < (seconds_ > 2.0 * kFilling ? kFilling : kFillingShare * seconds_)) continue;
    t.push_back(s.t);
    resident.push_back(s.resident);
    allocated.push_back(s.allocated);
  }
  return {{"seconds", rounded(1e-9 * static_cast<double>(wall_.nsecsElapsed()), 0)},
          {"frames", static_cast<double>(pictures_)},
          {"commands", static_cast<double>(acted_)},
          {"openings", static_cast<double>(opened_)},
          {"t_s_resident_mb_allocated_mb", over_time},
          {"resident_mb_per_hour", rounded(kSecondsPerHour * slopeOf(t, resident), 2)},
          {"allocated_mb_per_hour", rounded(kSecondsPerHour * slopeOf(t, allocated), 2)}};
}

}  // namespace abstand::studio
