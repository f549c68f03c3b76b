// Stature, sizes and mass of one person.
#pragma once

#include <QWidget>

#include "core/view/snapshot.hpp"
#include "ui/document/body_preview.hpp"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QPushButton;

namespace abstand::ui {

class BodyView;

/// Fields that replace what the scene says of a person, once they are applied, and a drawing of the person
/// that they describe; what is not ticked is as in the scene. GUI thread only.
class PersonEditor : public QWidget {
  Q_OBJECT

 public:
  explicit PersonEditor(QWidget* parent = nullptr);

  /// Draws the person of the fields; without one nothing is drawn.
  void setPreviewer(BodyPreviewer previewer) { previewer_ = std::move(previewer); }
  /// `person`: index into SceneOutline::people. `present`: what the document says.
  void open(const view::SceneOutline& outline, int person, const PersonOptions& present);

 Q_SIGNALS:
  void wanted(const QString& person, const abstand::ui::PersonOptions& options);

 private:
  struct Field {
    QCheckBox* on;
    QDoubleSpinBox* box;
  };
  Field add(const QString& name, const char* object, double lower, double upper, const QString& unit);
  void fill(const Field& field, const std::optional<double>& value, double usual);
  PersonOptions options() const;
  void changed();
  void preview();

  QString person_;
  PersonOptions present_;
  QComboBox* sex_;
  Field stature_, percentile_, mass_;
  QPushButton* apply_;
  BodyView* body_;
  BodyPreviewer previewer_;
};

}  // namespace abstand::ui
