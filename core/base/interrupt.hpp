// Requests of the user or the system to end the program: Ctrl-C, SIGTERM, SIGHUP.
#pragma once

#include <stdexcept>

namespace abstand {

/// Catches SIGINT, SIGTERM and SIGHUP (unless the parent process ignores them, as nohup does), and lets
/// writes to closed pipes and to files at their size limit fail instead of ending the process. Blocking
/// system calls return EINTR. A second signal, 0.25 s after the first or later, ends the process at once with
/// exit code 130.
void catchInterrupts();

/// True after the first of these signals. Any thread.
bool interruptRequested() noexcept;

/// Thrown when waiting ends because of such a signal.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace abstand
