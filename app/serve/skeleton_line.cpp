#include "app/serve/skeleton_line.hpp"

#include "app/serve/json_line.hpp"

namespace abstand::serve {

bool isLineName(std::string_view name) {
  const auto fits = [](char c) { return static_cast<unsigned char>(c) >= 0x20 && c != '"' && c != '\\'; };
  return !name.empty() && name.size() <= kMaxNameBytes && std::all_of(name.begin(), name.end(), fits);
}

std::size_t writeSkeletonLine(const humanmodel::SkeletonFrame& frame, std::string_view person,
                              std::uint32_t sequence, std::uint64_t time_us,
                              std::span<std::byte> into) noexcept {
  JsonLine out(into);
  out.text("{\"type\":\"skeleton\",\"seq\":").number(sequence).text(",\"time_us\":").number(time_us);
  out.text(",\"person\":\"").text(person).text("\",\"joints\":{");
  bool first = true;
  for (std::size_t j = 0; j < humanmodel::kJointCount; ++j) {
    const auto joint = static_cast<humanmodel::Joint>(j);
    if (!frame.has(joint)) continue;
    out.text(first ? "\"" : ",\"").text(humanmodel::jointName(joint)).text("\":[");
    first = false;
    out.number(frame.p[j].x()).text(",").number(frame.p[j].y()).text(",").number(frame.p[j].z());
    if (frame.state[j] == humanmodel::JointState::kInferred) out.text(",\"inferred\"");
    if (frame.spread[j] > 0.0) out.text(",").number(frame.spread[j]);
    out.text("]");
  }
  return out.text("}}").size();
}

}  // namespace abstand::serve
