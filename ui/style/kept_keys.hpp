// The keys that a user gave to commands, in the settings.
#pragma once

namespace abstand::ui {

class Actions;

/// Keeps the keys that differ from the default ones, by the names of the actions.
void saveKeys(const Actions& actions);
/// Applies what was kept. Names and keys that are not known are passed over; where two commands would have
/// the same key, all keep their default ones.
void loadKeys(const Actions& actions);
/// All commands have their default keys.
void resetKeys(const Actions& actions);

}  // namespace abstand::ui
