#include "app/cli/worn_arguments.hpp"

#include <algorithm>

#include "core/base/error.hpp"

namespace abstand::cli {
namespace {

constexpr const char* kToolForm =
    "expected HAND=SHAPE or HAND=MESH, left or right, with @x,y,z or @x,y,z,roll,pitch,yaw behind it";

Transform poseIn(const std::string& text, const std::string& whole) {
  const std::vector<double> v = numberList(text, "--tool");
  if (v.size() != 3 && v.size() != 6) throw UsageError("--tool: found '" + whole + "', " + kToolForm);
  const bool turned = v.size() == 6;
  return fromXyzRpy({v[0], v[1], v[2]}, turned ? Vector3d(v[3], v[4], v[5]) : Vector3d::Zero());
}

}  // namespace

humanmodel::Clothing clothingOf(const std::string& text) {
  humanmodel::Clothing clothing;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    begin = end + 1;
    if (const auto equals = item.find('='); equals != std::string::npos) {
      const humanmodel::BodyPart part = bodyPart(item.substr(0, equals), "--clothing");
      humanmodel::addClothing(
          {{part, numberWithin(item.substr(equals + 1), "--clothing", 0.0, humanmodel::kMaxClothing, "m")}},
          clothing);
    } else if (!humanmodel::addClothingPreset(item, clothing)) {
      std::string known;
      for (const std::string_view name : humanmodel::clothingPresets()) known += std::string(name) + ", ";
      throw UsageError("--clothing: found '" + item + "', expected " + known + "or PART=m");
    }
  }
  return clothing;
}

scene_file::ToolDescription toolOf(const std::string& text) {
  const auto equals = text.find('=');
  const std::string hand = text.substr(0, equals);
  if (equals == std::string::npos || (hand != "left" && hand != "right"))
    throw UsageError("--tool: found '" + text + "', " + kToolForm);
  scene_file::ToolDescription tool;
  tool.hand = hand == "left" ? humanmodel::BodyPart::kHandLeft : humanmodel::BodyPart::kHandRight;
  const auto at = text.rfind('@');
  const std::string body = text.substr(equals + 1, at == std::string::npos ? at : at - equals - 1);
  if (at != std::string::npos) tool.X_HT = poseIn(text.substr(at + 1), text);
  tool.shape = geometry::parseShape(body);
  if (tool.shape) {
    tool.name = std::string(geometry::shapeName(*tool.shape));
    return tool;
  }
  tool.mesh = body;
  std::error_code ec;
  if (!std::filesystem::is_regular_file(tool.mesh, ec))
    throw UsageError("--tool: found no file '" + body + "', " + kToolForm);
  tool.name = tool.mesh.stem().string();
  std::replace(tool.name.begin(), tool.name.end(), ',', '_');
  std::replace(tool.name.begin(), tool.name.end(), '"', '_');
  return tool;
}

void WornArguments::add(CLI::App& command) {
  command.add_option("--clothing", clothing,
                     "what people wear, in addition to the scene: PRESET,PART=m,...: work_clothes, "
                     "winter_clothes, gloves, thick_gloves, helmet, safety_shoes, or m for a part");
  command.add_option("--tool", tools,
                     "HAND=SHAPE[@POSE] or HAND=MESH[@POSE]: a tool in the left or right hand, as "
                     "right=cylinder:0.01,0.3@0.1,0,0");
}

tune::WornVariant WornArguments::worn() const {
  tune::WornVariant worn{clothingOf(clothing), {}};
  for (const std::string& text : tools) {
    worn.tools.push_back(toolOf(text));
    // A second cylinder in the same hand is cylinder_2.
    const std::string name = worn.tools.back().name;
    const auto taken = [&] {
      return std::any_of(worn.tools.begin(), worn.tools.end() - 1, [&](const auto& other) {
        return other.bodyName("") == worn.tools.back().bodyName("");
      });
    };
    for (int i = 2; taken(); ++i) worn.tools.back().name = name + "_" + std::to_string(i);
  }
  return worn;
}

}  // namespace abstand::cli
