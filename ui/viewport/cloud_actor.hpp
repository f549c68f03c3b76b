// Measured points between the bodies. VTK: .cpp files only.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <set>

#include "ui/model/depth_cloud.hpp"

namespace abstand::ui {

/// Bodies hide the points behind them, and points what is behind them.
class CloudActor {
 public:
  explicit CloudActor(vtkRenderer* renderer);

  /// Draws these points in place of those before.
  void show(const std::vector<CloudPoint>& points, CloudColours colours);
  void setVisible(bool visible) { actor_->SetVisibility(visible); }
  /// Number of points that are drawn.
  std::size_t shown() const;
  CloudColours colours() const { return colours_; }
  /// Among the drawn points is one that is coloured as this one.
  bool has(const CloudPoint& point) const;

 private:
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkActor> actor_;
  CloudColours colours_{CloudColours::kParts};
  std::set<QRgb> drawn_;  // colours of the points
};

}  // namespace abstand::ui
