// Previews of people for the person editor.
#pragma once

#include <map>
#include <string>

#include "humanmodel/human_model.hpp"
#include "ui/document/body_preview.hpp"

namespace abstand::studio {

/// Bodies of the people as the scene file describes them, by name.
using SceneBodies = std::map<std::string, humanmodel::HumanOptions>;

/// The person of these options with `changed` in place of what it sets, and for comparison people of the
/// model of measured sizes: the woman of the 5th and the man of the 95th percentile. No throw for options
/// that no person has: then `problem` says why.
ui::BodyPreview bodyPreview(const humanmodel::HumanOptions& in_scene, const ui::PersonOptions& changed);

}  // namespace abstand::studio
