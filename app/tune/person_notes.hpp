// Who the people of a run are.
#pragma once

#include "app/tune/recording_tune.hpp"

namespace abstand::tune {

/// Size, preset, clothing and tools of each person of the scene, in one line each.
std::vector<PersonNote> peopleOf(const session::Session& session);

/// TunedRecording::enclosed, judged among people of the sex that the scene states, else of both.
std::vector<humanmodel::EnclosedShare> enclosedIn(const session::Session& session, const PassResult& pass);

}  // namespace abstand::tune
