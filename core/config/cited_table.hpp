// What every table of numbers of a standard has in common: where it comes from, and its stamp in reports.
#pragma once

#include <filesystem>

#include "core/base/content_hash.hpp"
#include "core/config/cited_value.hpp"

namespace abstand::config {

/// Reads title, edition, note, origin and to_be_checked of `fields` into the members of these names, and sets
/// `file` and `content`. `text`: the whole file. Throws ParseError.
template <class Table>
void readTableHead(const YamlFields& fields, const std::string& text, Table& table) {
  table.title = neededText(fields, "title");
  table.edition = neededText(fields, "edition");
  table.note = fields.text("note").value_or("");
  table.origin = fields.text("origin").value_or("");
  table.to_be_checked = textList(fields, "to_be_checked");
  table.file = fields.file();
  ContentHash hash;
  hash.add(text.data(), text.size());
  table.content = hash.value();
}

/// "title, edition, file name, first 12 digits of the content's hash".
template <class Table>
std::string tableStamp(const Table& table) {
  constexpr std::size_t kDigits = 12;
  return table.title + ", " + table.edition + ", " + std::filesystem::path(table.file).filename().string() +
         ", " + table.content.hex().substr(0, kDigits);
}

}  // namespace abstand::config
