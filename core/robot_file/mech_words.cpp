#include "core/robot_file/mech_words.hpp"

namespace abstand::robot_file {

std::vector<MechLine> splitMechWords(std::string_view text) {
  constexpr std::string_view kBlank = " \t";
  std::vector<MechLine> lines;
  int number = 0;
  while (!text.empty()) {
    ++number;
    const auto end = text.find('\n');
    std::string_view content = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (content.ends_with('\r')) content.remove_suffix(1);
    content = content.substr(0, content.find('#'));

    MechLine line{number, 1, {}};
    for (auto begin = content.find_first_not_of(kBlank); begin != std::string_view::npos;) {
      auto stop = content.find_first_of(kBlank, begin);
      if (stop == std::string_view::npos) stop = content.size();
      line.words.push_back({content.substr(begin, stop - begin), static_cast<int>(begin) + 1});
      line.end_column = static_cast<int>(stop) + 1;
      begin = content.find_first_not_of(kBlank, stop);
    }
    if (!line.words.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace abstand::robot_file
