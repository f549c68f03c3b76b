#include "tracking/recording/required_person.hpp"

#include "core/base/error.hpp"

namespace abstand::tracking {

void requirePerson(const RecordingReport& report, const std::string& file) {
  if (!report.mapped.empty()) return;
  if (!report.person.no_body.empty())
    throw ParseError({file}, "found a skeleton without a body, expected bones with a length",
                     report.person.no_body);
  const std::string hint =
      report.units.doubt.empty()
          ? "`abstand skeleton FILE --write-map own.map` writes a joint map to fill in; give it as "
            "--joint-map, or as joint_map of the recording in a scene"
          : report.units.doubt;
  throw ParseError({file}, "found no body part with both end joints, expected at least one", hint);
}

}  // namespace abstand::tracking
