#include "core/robot_file/mech_reader.hpp"

#include <algorithm>
#include <cctype>

#include "core/base/error.hpp"
#include "core/base/number.hpp"
#include "core/text/message_text.hpp"

namespace abstand::robot_file {

void MechReader::fail(int line, int column, const std::string& message, const std::string& hint) const {
  throw ParseError({name_, line, column}, message, hint);
}

void MechReader::unknown(const MechLine& line, std::size_t i, const std::string& expected,
                         const std::vector<std::string>& known) const {
  const auto& word = line.words[i];
  std::string lower(word.text.substr(0, 64));
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::string near = nearestName(lower, known);
  std::string hint;
  if (near == lower && !near.empty())
    hint = "words are written in lowercase: " + near;
  else if (!near.empty())
    hint = "did you mean " + near + "?";
  fail(line.line, word.column, "found " + text::inQuotes(word.text) + ", expected " + expected, hint);
}

void MechReader::expectValues(const MechLine& line, std::size_t count, const std::string& what) const {
  const std::size_t found = line.words.size() - 1;
  if (found == count) return;
  const int column = found > count ? line.words[count + 1].column : line.end_column;
  fail(line.line, column,
       "found " + std::to_string(found) + (found == 1 ? " value" : " values") + " behind " +
           text::inQuotes(line.words[0].text) + ", expected " + std::to_string(count) + ": " + what);
}

void MechReader::expectAlone(const MechLine& line) const {
  if (line.words.size() > 1)
    fail(line.line, line.words[1].column,
         "found " + text::inQuotes(line.words[1].text) + ", expected the end of the line after " +
             text::inQuotes(line.words[0].text));
}

const MechLine* MechReader::command(const MechLine& begin, const std::vector<std::string>& known) {
  const std::string end_tag = "end_" + std::string(begin.words[0].text);
  const MechLine* line = nextLine();
  if (!line)
    fail(begin.line, begin.words[0].column,
         "found the end of the file inside this environment, expected " + end_tag);
  const auto word = line->words[0].text;
  if (word == end_tag) {
    expectAlone(*line);
    return nullptr;
  }
  if (std::find(known.begin(), known.end(), word) == known.end()) {
    std::string expected;
    for (const auto& k : known) expected += k + ", ";
    expected.resize(expected.size() - 2);
    auto all = known;
    all.push_back(end_tag);
    unknown(*line, 0, expected + " or " + end_tag, all);
  }
  return line;
}

MechNumber MechReader::number(const MechLine& line, std::size_t i, const std::string& what) const {
  const auto& word = line.words[i];
  const auto value = parseDouble(word.text);
  if (!value)
    fail(line.line, word.column,
         "found " + text::inQuotes(word.text) + ", expected " + what + ": a finite number");
  return {*value, line.line, word.column};
}

MechNumber MechReader::integer(const MechLine& line, std::size_t i, int min, const std::string& what) const {
  const auto& word = line.words[i];
  const auto value = parseInt(word.text);
  if (!value || *value < min)
    fail(line.line, word.column,
         "found " + text::inQuotes(word.text) + ", expected " + what + ": a whole number from " +
             std::to_string(min) + " on");
  return {static_cast<double>(*value), line.line, word.column};
}

}  // namespace abstand::robot_file
