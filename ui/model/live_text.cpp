#include "ui/model/live_text.hpp"

#include <cmath>

#include "ui/style/format.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

namespace {

using State = LiveStatus::State;
constexpr double kMillisecondsBelow = 1.0;  // s
constexpr double kMebibyte = 1048576.0;

QString ageText(double seconds) {
  if (!std::isfinite(seconds)) return tr("–");
  if (seconds < kMillisecondsBelow) return tr("%1 ms").arg(fixed(1e3 * seconds, 0));
  return tr("%1 s").arg(fixed(seconds, 1));
}

QString connectionText(const LiveStatus& status) {
  switch (status.state) {
    case State::kFile:
      return tr("recorded moments");
    case State::kOtherScene:
      return tr("⚠ stale: the server shows another scene");
    case State::kConnecting:
    case State::kStale:
      return std::isfinite(status.silence)
                 ? tr("⚠ stale: nothing received for %1").arg(ageText(status.silence))
                 : tr("⚠ not connected");
    case State::kConnected:
      break;
  }
  return tr("connected, %1 moments/s, newest %2 old").arg(fixed(status.rate, 0), ageText(status.age));
}

}  // namespace

bool isStale(const LiveStatus& status) {
  return status.state != State::kConnected && status.state != State::kFile;
}

QString liveText(const LiveStatus& status) {
  QString text = connectionText(status);
  if (status.rewound && status.state != State::kFile)
    text = tr("%1 ago; %2").arg(ageText(status.behind), text);
  if (status.other_file) text = tr("⚠ scene file differs; %1").arg(text);
  return text;
}

QString liveLines(const LiveStatus& status) {
  QString text = tr("Shown is what abstand serve computed. Margins, pairs and poses are the server's.");
  text += '\n' + tr("Kept: the last %1, %2 MiB")
                     .arg(ageText(status.kept), fixed(static_cast<double>(status.bytes) / kMebibyte, 0));
  text +=
      '\n' + tr("Moments that the server left out because this window was too slow: %1").arg(status.left_out);
  if (status.other_file)
    text += '\n' + tr("The scene file here has another content than the server's: shapes, margins and limits "
                      "may differ.");
  return text;
}

}  // namespace abstand::ui
