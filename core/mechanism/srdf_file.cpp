#include "core/mechanism/srdf_file.hpp"

#include "core/base/text_file.hpp"
#include "core/mechanism/robot.hpp"
#include "core/mechanism/xml_values.hpp"

namespace abstand {

Srdf parseSrdf(const std::string& text, const std::string& file) {
  const XmlElement robot = mesh_file::parseXml(text, file);
  const XmlValues values(file);
  if (robot.name != "robot")
    values.fail(robot, "found <" + std::string(robot.name.substr(0, 40)) + ">, expected <robot>: an SRDF");
  Srdf srdf;
  srdf.robot = values.text(robot, "name").value_or("");
  for (const auto& e : robot.children) {
    if (e.name == "link" || e.name == "joint")
      values.fail(e, "found <" + std::string(e.name) + ">, expected an SRDF",
                  "this is a URDF, which names the robot itself");
    if (e.name != "disable_collisions") continue;
    DisabledPair pair;
    pair.link1 = values.needText(e, "link1");
    pair.link2 = values.needText(e, "link2");
    pair.reason = values.text(e, "reason").value_or("");
    pair.pos = values.pos(e);
    if (pair.link1 == pair.link2)
      values.fail(e, "found a pair of " + pair.link1 + " with itself, expected two links");
    srdf.disabled.push_back(std::move(pair));
  }
  return srdf;
}

Srdf loadSrdf(const std::filesystem::path& file) {
  return parseSrdf(readFile(file, kMostRobotBytes), file.string());
}

std::string srdfText(const Srdf& srdf) {
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" + xmlEscaped(srdf.robot) + "\">\n";
  for (const auto& pair : srdf.disabled)
    text += "  <disable_collisions link1=\"" + xmlEscaped(pair.link1) + "\" link2=\"" +
            xmlEscaped(pair.link2) + "\" reason=\"" + xmlEscaped(pair.reason) + "\"/>\n";
  return text + "</robot>\n";
}

}  // namespace abstand
