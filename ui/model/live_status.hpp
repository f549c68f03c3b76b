// How a session that shows the moments of another program is connected with it.
#pragma once

#include <cstddef>

namespace abstand::ui {

struct LiveStatus {
  enum class State {
    kConnecting,  ///< no moment yet, or the connection is lost
    kConnected,
    kStale,       ///< nothing was heard for too long: what is shown may not hold any more
    kOtherScene,  ///< the other program shows another scene now
    kFile         ///< recorded moments; there is no connection
  };
  State state{State::kConnecting};
  double rate{0.0};        ///< moments that arrived in the last second
  double age{0.0};         ///< s since the newest moment arrived
  double silence{0.0};     ///< s since anything arrived; infinite: nothing ever did
  bool rewound{false};     ///< an earlier moment is shown
  double behind{0.0};      ///< s since the shown moment, where an earlier one is shown
  bool other_file{false};  ///< the scene file here has another content than that of the other program
  double kept{0.0};        ///< s that can be shown again
  std::size_t bytes{0};    ///< that they take
  unsigned left_out{0};    ///< moments that the other program left out, as we were too slow
  bool can_reset{false};   ///< SessionPort::resetStops() reaches the robots
};

}  // namespace abstand::ui
