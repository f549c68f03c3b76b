// Project files: the document as JSON.
#pragma once

#include <QString>

#include "ui/document/work.hpp"

namespace abstand::ui {

/// Ending of the files' names.
inline constexpr char kProjectSuffix[] = "abstand";

/// The text of a project file. The same project gives the same bytes.
/// @param folder  that the file will be in: paths are relative to it; empty: paths are absolute
/// @param saved_as  of an autosave: the project file that it belongs to; empty: none
std::string projectText(const Project& project, const QString& folder, const QString& saved_as = {});

/// What a project file holds.
struct ProjectFile {
  Project project;   ///< with absolute paths
  QString saved_as;  ///< as in projectText()
};

/// The inverse of projectText(). Throws ParseError, with file, line and column, for anything that
/// projectText() does not write. Files that the project names need not exist.
/// @param file  for messages
ProjectFile parseProject(const std::string& text, const QString& file, const QString& folder);

/// Writes whole or not at all. Throws UsageError, also for names that a project file cannot hold (with a line
/// break), and WriteError.
void writeProject(const Project& project, const QString& file);
/// Throws ParseError, also for a file that cannot be read.
Project readProject(const QString& file);

}  // namespace abstand::ui
