// What the tour of the window shows.
#include "ui/tour_steps.hpp"

#include "ui/dock_set.hpp"
#include "ui/style/tr.hpp"

namespace abstand::ui {

std::vector<Tour::Step> tourSteps(const DockSet& docks) {
  return {
      {nullptr, tr("The 3D view"),
       tr("Drag with the left button to orbit, with the right one to pan, and turn the wheel to zoom. A "
          "click "
          "selects a body. Thin lines join the nearest points of people and robots; what is inside its "
          "margin "
          "is vermillion with an outline.")},
      {docks.scene, tr("The scene"),
       tr("All bodies by group, each with its distance to the nearest person or robot. A tick hides and "
          "shows; "
          "a body can be dragged onto the plots.")},
      {docks.timeline, tr("The timeline"),
       tr("Space plays, the arrow keys step, and a drag in the strip scrubs. Each body part has a lane: "
          "bright "
          "is near, a vermillion bar is inside the margin, hatched is not known. N goes to the next event.")},
      {docks.margins, tr("Margins"),
       tr("The safety margin of each body. Drag a slider: lanes, events and the sentence above the strip say "
          "at "
          "once what it would have done over the whole recording.")},
      {docks.pairs, tr("Pairs"),
       tr("Each pair of bodies with its distance and its uncertainty. The true distance is never below "
          "distance "
          "minus uncertainty.")},
      {docks.separation, tr("Separation"),
       tr("For each body part the protective distance that ISO/TS 15066:2016 asks for at this moment, term "
          "by "
          "term, "
          "against the distance that is there; and how a contact would compare with its limit.")},
      {docks.inspector, tr("Inspector"),
       tr("All that is known of the selection. A robot has sliders for its joints, a person fields for "
          "stature "
          "and mass.")},
      {docks.notes, tr("Reservations"),
       tr("What weakens the results: lost poses, gaps, guessed units. Read it before you believe a number. "
          "This "
          "is an analysis tool, not a safety function.")}};
}

}  // namespace abstand::ui
