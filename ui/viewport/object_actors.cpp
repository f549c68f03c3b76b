// One actor an object.
#include "ui/viewport/object_actors.hpp"

#include <vtkCellPicker.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "ui/model/groups.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/stop_text.hpp"
#include "ui/viewport/mesh_data.hpp"

namespace abstand::ui {

namespace {

constexpr double kMinMist = 2e-3;  // m; less is not seen
constexpr double kMistOpacity = 0.16;
constexpr float kHollowLine = 2.0F;  // px
constexpr double kHaltTint = 0.5;    // share of amber in a link that is stopped; half of it where slowed down

void setColour(vtkProperty* property, const QColor& c) {
  property->SetColor(c.redF(), c.greenF(), c.blueF());
}

bool assign(vtkMatrix4x4* matrix, const Eigen::Matrix4d& m) {
  bool changed = false;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) changed |= matrix->GetElement(r, c) != m(r, c);
  if (!changed) return false;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) matrix->SetElement(r, c, m(r, c));
  return true;
}

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto mix = [&](double x, double y) { return x + share * (y - x); };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()));
}

bool show(vtkActor* actor, bool visible) {
  if ((actor->GetVisibility() != 0) == visible) return false;
  actor->SetVisibility(visible);
  return true;
}

}  // namespace

void ObjectActors::open(const view::SceneOutline& outline, const PreparedMeshes& meshes, Theme theme) {
  for (const Item& item : items_) {
    renderer_->RemoveActor(item.body);
    renderer_->RemoveActor(item.outline);
    renderer_->RemoveActor(item.mist);
  }
  items_.assign(outline.objects.size(), {});
  infos_ = outline.objects;
  theme_ = theme;
  std::vector<vtkSmartPointer<vtkPolyData>> shadows(items_.size());
  const MeshData nothing{vtkSmartPointer<vtkPolyData>::New(), vtkSmartPointer<vtkPolyData>::New(),
                         vtkSmartPointer<vtkPolyData>::New()};
  for (std::size_t i = 0; i < items_.size(); ++i) {
    Item& item = items_[i];
    item.human = infos_[i].human;
    const auto reacting = std::find(outline.reacting.begin(), outline.reacting.end(), infos_[i].group);
    if (reacting != outline.reacting.end())
      item.reacting = static_cast<int>(reacting - outline.reacting.begin());
    item.pose = vtkSmartPointer<vtkMatrix4x4>::New();
    const MeshData& data = i < meshes.objects.size() ? meshes.objects[i] : nothing;
    if (i < outline.meshes.size() && !outline.meshes[i].vertices.empty()) {
      geometry::Bounds box;
      for (const Vector3d& v : outline.meshes[i].vertices) box.add(v);
      item.centre = 0.5 * (box.lower + box.upper);
      item.half = (0.5 * (box.upper - box.lower)).cwiseMax(1e-6);
    }
    item.mist_pose = vtkSmartPointer<vtkMatrix4x4>::New();
    item.mist = addActor(renderer_, data.surface, item.mist_pose);
    item.mist->GetProperty()->LightingOff();
    item.mist->GetProperty()->SetOpacity(kMistOpacity);
    item.mist->GetProperty()->BackfaceCullingOn();
    item.mist->VisibilityOff();
    shadows[i] = data.shadow;
    item.outline = addActor(renderer_, data.hull, item.pose);
    item.outline->GetProperty()->LightingOff();
    item.outline->GetProperty()->FrontfaceCullingOn();
    item.outline->VisibilityOff();
    item.body = addActor(renderer_, data.surface, item.pose);
    vtkProperty* look = item.body->GetProperty();
    look->SetInterpolationToGouraud();
    look->SetAmbient(0.30);
    look->SetDiffuse(0.80);
    look->SetSpecular(0.12);
    look->SetSpecularPower(18.0);
    look->BackfaceCullingOn();
  }
  shadows_.open(shadows);
  setTheme(theme);
}

vtkSmartPointer<vtkActor> ObjectActors::addActor(vtkRenderer* renderer, vtkPolyData* data,
                                                 vtkMatrix4x4* pose) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetUserMatrix(pose);
  renderer->AddActor(actor);
  return actor;
}

void ObjectActors::setTheme(Theme theme) {
  theme_ = theme;
  view::SceneOutline names;
  names.objects = infos_;
  const SceneColours colours = sceneColours(theme);
  shadows_.setColour(colours.shadow);
  for (const Group& group : groupsOf(names)) {
    for (std::size_t k = 0; k < group.objects.size(); ++k) {
      Item& item = items_[static_cast<std::size_t>(group.objects[k])];
      item.colour = group.kind == GroupKind::kHuman     ? colours.human
                    : group.kind == GroupKind::kObjects ? colours.objects
                                                        : mechanismColour(group.index_of_kind, theme);
      // Neighbouring links differ a little, so that the joints can be seen.
      if (group.kind == GroupKind::kMechanism && k % 2 == 1) item.colour = item.colour.darker(109);
      setColour(item.body->GetProperty(), item.colour);
      setColour(item.mist->GetProperty(), item.colour);
    }
  }
}

bool ObjectActors::refresh(const view::SceneSnapshot& snapshot, const std::vector<BodyState>& states,
                           const Selection& selection, const ViewOptions& options) {
  bool changed = false;
  const std::size_t n = std::min(items_.size(), snapshot.objects.size());
  for (std::size_t i = 0; i < n; ++i) {
    changed |= place(items_[i], snapshot.objects[i].X_WB);
    changed |=
        shadows_.set(i, snapshot.objects[i].X_WB, items_[i].visible && options.floor && options.shadows);
    const PairLevel level = i < states.size() ? states[i].level : PairLevel::kUnknown;
    const Look look{selection.contains(static_cast<int>(i)), haltOf(items_[i], snapshot), level};
    changed |= paint(items_[i], snapshot.objects[i], look, options);
  }
  return changed;
}

bool ObjectActors::place(Item& item, const Transform& X_WB) { return assign(item.pose, X_WB.matrix()); }

bool ObjectActors::veil(Item& item, const view::ObjectSnapshot& now, bool hollow) {
  const bool misty =
      item.visible && !hollow && std::isfinite(now.pose_uncertainty) && now.pose_uncertainty > kMinMist;
  bool changed = show(item.mist, misty);
  if (!misty) return changed;
  const Vector3d by = (item.half.array() + now.pose_uncertainty) / item.half.array();
  Eigen::Affine3d stretched(now.X_WB.matrix());
  stretched.translate(item.centre).scale(by).translate(-item.centre);
  return assign(item.mist_pose, stretched.matrix()) || changed;
}

ObjectActors::Halt ObjectActors::haltOf(const Item& item, const view::SceneSnapshot& snapshot) {
  if (item.reacting < 0 || static_cast<std::size_t>(item.reacting) >= snapshot.robots.size())
    return Halt::kNone;
  const safety::StopState state = snapshot.robots[static_cast<std::size_t>(item.reacting)].state;
  if (isStop(state)) return Halt::kStopped;
  return state == safety::StopState::kSlowing ? Halt::kSlowed : Halt::kNone;
}

bool ObjectActors::paint(Item& item, const view::ObjectSnapshot& now, const Look& as,
                         const ViewOptions& options) {
  vtkProperty* look = item.body->GetProperty();
  const auto before = look->GetMTime();
  const bool chosen = as.chosen, halted = as.halt != Halt::kNone, stopped = as.halt == Halt::kStopped;
  const bool hollow = scene::isPoseLost(now.pose_state);
  const bool broken = isBroken(as.level);
  const bool marked = broken || chosen || halted;
  setColour(look, broken   ? levelColour(as.level)
                  : halted ? mixed(item.colour, QColor(kAmber), stopped ? kHaltTint : 0.5 * kHaltTint)
                           : item.colour);
  look->SetRepresentation(hollow ? VTK_WIREFRAME : VTK_SURFACE);
  look->SetLighting(!hollow);
  // The mist of its neighbours lies over it.
  look->SetLineWidth(hollow ? kHollowLine : 1.0F);
  // An inferred pose is between known and lost: whole, but with its edges.
  look->SetEdgeVisibility(now.pose_state == scene::PoseState::kInferred);
  look->SetEdgeColor(0.45, 0.5, 0.55);
  look->SetOpacity(item.human && !marked ? options.shownOpacity() : 1.0);
  bool changed = look->GetMTime() != before;

  vtkProperty* edge = item.outline->GetProperty();
  const auto edge_before = edge->GetMTime();
  setColour(edge, chosen   ? QColor(kAccent)
                  : broken ? levelColour(as.level).darker(190)
                           : QColor(stopped ? kVermillion : kAmber));
  changed |= edge->GetMTime() != edge_before;
  changed |= show(item.body, item.visible);
  changed |= veil(item, now, hollow);
  // What is hidden shows itself as an outline when it touches something or is inside a margin.
  changed |= show(item.outline, marked && !hollow && (item.visible || broken));
  return changed;
}

void ObjectActors::setVisible(int object, bool visible) {
  if (object >= 0 && static_cast<std::size_t>(object) < items_.size())
    items_[static_cast<std::size_t>(object)].visible = visible;
}

geometry::Bounds ObjectActors::bounds(const std::vector<int>& only) const {
  geometry::Bounds box;
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const bool wanted = only.empty() ? items_[i].visible
                                     : std::find(only.begin(), only.end(), static_cast<int>(i)) != only.end();
    const double* b = items_[i].body->GetBounds();
    if (!wanted || !b || b[0] > b[1]) continue;
    box.add({b[0], b[2], b[4]});
    box.add({b[1], b[3], b[5]});
  }
  return box;
}

int ObjectActors::pick(double x, double y, Vector3d* at) const {
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.0);
  picker->PickFromListOn();
  for (const Item& item : items_)
    if (item.visible) picker->AddPickList(item.body);
  if (!picker->Pick(x, y, 0.0, renderer_)) return -1;
  if (at) picker->GetPickPosition(at->data());
  for (std::size_t i = 0; i < items_.size(); ++i)
    if (items_[i].body == picker->GetActor()) return static_cast<int>(i);
  return -1;
}

}  // namespace abstand::ui
