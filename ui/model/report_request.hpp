// A report that the user wants.
#pragma once

#include <QMetaType>
#include <QString>
#include <string>

#include "ui/model/what_if_settings.hpp"

namespace abstand::ui {

/// Options of `abstand tune --report`; its defaults.
struct ReportRequest {
  QString file;            ///< absolute path of the HTML page
  std::string margin_set;  ///< the present margins, as a file of margins says them
  WhatIfSettings what_if;  ///< what it is judged with
};

}  // namespace abstand::ui

Q_DECLARE_METATYPE(abstand::ui::ReportRequest)
