#include "app/tune/person_notes.hpp"

#include <algorithm>

#include "core/base/number.hpp"

namespace abstand::tune {
namespace {

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string clothingText(const humanmodel::Clothing& clothing) {
  std::string text;
  for (const auto& [part, thickness] : clothing)
    if (thickness > 0.0)
      text += (text.empty() ? "" : ", ") + std::string(humanmodel::partName(part)) + " " +
              fixed(1e3 * thickness, 0) + " mm";
  return text.empty() ? "none" : text;
}

std::string noteOf(const scene_file::HumanDescription& d, const humanmodel::HumanModel& model) {
  const humanmodel::HumanOptions& o = model.options;
  std::string text = fixed(model.height, 3) + " m, " + fixed(model.mass, 1) + " kg";
  if (o.percentile) text += ", percentile " + formatDouble(*o.percentile);
  text += !o.sex ? ", mean of both sexes" : *o.sex == humanmodel::Sex::kFemale ? ", female" : ", male";
  text += o.preset == humanmodel::HumanPreset::kThesis ? ", preset thesis" : ", preset anthropometric";
  if (d.follow_lengths) text += ", bone lengths of the recording";
  if (!o.overrides.empty()) text += ", single parts as in the scene";
  text += "; clothing: " + clothingText(o.clothing) + "; tools: ";
  if (d.tools.empty()) return text + "none";
  for (std::size_t i = 0; i < d.tools.size(); ++i)
    text += (i ? ", " : "") + d.tools[i].bodyName("").substr(1);
  return text;
}

}  // namespace

std::vector<PersonNote> peopleOf(const session::Session& session) {
  std::vector<PersonNote> people;
  const auto& descriptions = session.description().humans;
  for (std::size_t i = 0; i < descriptions.size(); ++i)
    people.push_back({descriptions[i].name, noteOf(descriptions[i], session.humans()[i]->model())});
  return people;
}

std::vector<humanmodel::EnclosedShare> enclosedIn(const session::Session& session, const PassResult& pass) {
  std::vector<humanmodel::EnclosedShare> shares(pass.parts.size(), {1.0, 1.0});
  for (const auto& human : session.humans()) {
    const auto of_person = humanmodel::enclosedShare(human->model(), human->model().options.sex);
    for (std::size_t p = 0; p < shares.size(); ++p) {
      const auto part = humanmodel::parsePart(pass.parts[p].part);
      if (!part) continue;
      const humanmodel::EnclosedShare& here = of_person[humanmodel::index(*part)];
      shares[p] = {std::min(shares[p].at_stature, here.at_stature),
                   std::min(shares[p].all_statures, here.all_statures)};
    }
  }
  return shares;
}

}  // namespace abstand::tune
