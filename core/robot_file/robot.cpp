#include "core/robot_file/robot.hpp"

#include "core/base/text_file.hpp"
#include "core/robot_file/mech_file.hpp"
#include "core/robot_file/urdf_file.hpp"

namespace abstand::robot_file {

Robot loadRobot(const std::filesystem::path& file) {
  const std::string text = readFile(file, kMaxRobotBytes);
  const std::size_t bom = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  const auto first = text.find_first_not_of(" \t\r\n", bom);
  Robot robot = first != std::string::npos && text[first] == '<' ? parseUrdf(text, file.string())
                                                                 : parseMech(text, file.string());
  robot.file = file;
  return robot;
}

}  // namespace abstand::robot_file
