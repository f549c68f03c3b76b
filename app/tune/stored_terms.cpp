#include "app/tune/stored_terms.hpp"

#include <cmath>

#include "app/tune/line_fields.hpp"
#include "core/base/error.hpp"
#include "core/base/number.hpp"

namespace abstand::tune {
namespace {

constexpr std::size_t kTermFields = 4;

}  // namespace

std::vector<CitedTerm> citedTerms(const safety::SeparationStandard& standard) {
  std::vector<CitedTerm> terms;
  for (const auto& [key, cited] : standard.terms)
    terms.push_back({key, cited.source, cited.to_be_checked, cited.value});
  return terms;
}

std::string speedsEdition(const TunedRecording& recording) {
  return recording.separation_edition.empty() ? safety::kApproachSpeedEdition : recording.separation_edition;
}

std::string termLine(const CitedTerm& term) {
  return fieldText(term.key) + "\t" + formatDouble(term.value) + "\t" + fieldText(term.source) + "\t" +
         fieldText(term.to_be_checked);
}

CitedTerm termOf(const std::string& line, const std::string& file) {
  const std::vector<std::string> fields = fieldsOf(line);
  const auto value = fields.size() == kTermFields ? parseDouble(fields[1]) : std::nullopt;
  if (!value || !std::isfinite(*value))
    throw ParseError(
        {file}, "found a damaged term of the protective distance, expected key, number, source and doubt");
  return {fields[0], fields[2], fields[3], *value};
}

}  // namespace abstand::tune
