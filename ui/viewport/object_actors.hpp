// One actor an object, made when a scene opens; a frame only changes matrices and colours. VTK: .cpp files
// only.
#pragma once

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <vector>

#include "core/view/snapshot.hpp"
#include "ui/document/view_options.hpp"
#include "ui/model/body_state.hpp"
#include "ui/style/theme.hpp"
#include "ui/viewport/prepared_meshes.hpp"
#include "ui/viewport/shadows.hpp"

namespace abstand::ui {

class Selection;

/// Drawn so that the state is seen without colour too: contact has an outline, so have the links of a robot
/// that its reaction slows down or stops, a lost pose is hollow, and
/// about a body that is not known well lies a mist as far as its pose uncertainty: the body stretched by it
/// along its own axes.
class ObjectActors {
 public:
  /// Bodies and outlines into `renderer`, shadows into `back`.
  ObjectActors(vtkRenderer* renderer, vtkRenderer* back) : renderer_{renderer}, shadows_{back} {}

  void open(const view::SceneOutline& outline, const PreparedMeshes& meshes, Theme theme);
  void setTheme(Theme theme);
  /// True when something looks different now.
  /// `states`: of the objects.
  bool refresh(const view::SceneSnapshot& snapshot, const std::vector<BodyState>& states,
               const Selection& selection, const ViewOptions& options);
  void setVisible(int object, bool visible);
  bool isVisible(int object) const { return items_[static_cast<std::size_t>(object)].visible; }
  Shadows& shadows() { return shadows_; }

  /// World box of what is visible, of the chosen objects where there are any.
  geometry::Bounds bounds(const std::vector<int>& only = {}) const;
  /// Nearest visible object under a display position (physical pixels from the lower left corner), -1 for
  /// none.
  int pick(double x, double y, Vector3d* at = nullptr) const;

 private:
  struct Item {
    vtkSmartPointer<vtkActor> body, outline, mist;
    vtkSmartPointer<vtkMatrix4x4> pose, mist_pose;
    Vector3d centre{Vector3d::Zero()}, half{Vector3d::Ones()};  ///< m, of the body's box
    QColor colour;
    bool human{false};
    bool visible{true};
    int reacting{-1};  ///< index of its robot in SceneOutline::reacting
  };
  enum class Halt { kNone, kSlowed, kStopped };
  struct Look {
    bool chosen{false};
    Halt halt{Halt::kNone};
    PairLevel level{PairLevel::kUnknown};
  };

  static vtkSmartPointer<vtkActor> addActor(vtkRenderer* renderer, vtkPolyData* data, vtkMatrix4x4* pose);
  static bool place(Item& item, const Transform& X_WB);
  bool veil(Item& item, const view::ObjectSnapshot& now, bool hollow);
  bool paint(Item& item, const view::ObjectSnapshot& now, const Look& look, const ViewOptions& options);
  static Halt haltOf(const Item& item, const view::SceneSnapshot& snapshot);

  vtkRenderer* renderer_;
  Shadows shadows_;
  std::vector<Item> items_;
  std::vector<view::SceneOutline::ObjectInfo> infos_;
  Theme theme_{Theme::kLight};
};

}  // namespace abstand::ui
