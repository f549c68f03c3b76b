// Speed and separation monitoring, and contact limits, at the moment.
#pragma once

#include <QWidget>
#include <memory>

#include "ui/model/separation_rows.hpp"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;

namespace abstand::ui {

class SeparationChart;

/// Only computes while it is in front. GUI thread only.
class SeparationPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SeparationPanel(QWidget* parent = nullptr);

  /// Null: contacts are not judged.
  void setLimits(std::shared_ptr<const contact::ContactLimits> limits);
  /// The outline must outlive its stay here.
  void open(const view::SceneOutline& outline);
  /// As the document has them; without a signal.
  void setSettings(const SeparationSettings& settings);
  const SeparationSettings& settings() const { return settings_; }
  void refresh(const view::SceneSnapshot& snapshot);
  SeparationChart* chart() const { return chart_; }

 Q_SIGNALS:
  /// By the user.
  void edited(const abstand::ui::SeparationSettings& settings);
  void pairPicked(int pair);

 private:
  struct Field {
    QDoubleSpinBox* box;
    double* value;  ///< in settings_
    double scale;   ///< shown unit in the unit of the value
  };
  QDoubleSpinBox* addField(const char* name, double& value, double most, double scale, const QString& suffix,
                           int decimals);

  std::shared_ptr<const contact::ContactLimits> limits_;
  const view::SceneOutline* outline_{nullptr};
  SeparationSettings settings_;
  std::vector<Field> fields_;
  QCheckBox* clamped_;
  QLabel* table_;
  SeparationChart* chart_;
};

}  // namespace abstand::ui
