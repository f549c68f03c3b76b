// Subsampling of a depth image, points and normals, distance transform to the person.
#include "tracking/tracker/body_view.hpp"

#include <algorithm>
#include <cmath>

namespace abstand::tracking {
namespace {

constexpr float kSameSurface = 0.05f;  // m, pixels of a cell farther apart belong to two surfaces
constexpr float kSmooth = 0.10f;       // m, neighbours farther apart give no normal
// Share of the pixels beside the person with a depth below which the background counts as removed.
constexpr double kBareBackground = 0.02;
constexpr std::int16_t kFar = 8192;  // cells

int squared(std::array<std::int16_t, 2> w) { return w[0] * w[0] + w[1] * w[1]; }

}  // namespace

double SeenPoints::top() const {
  float top = 0.0f;
  for (std::size_t i = 0; i < count; ++i) top = std::max(top, z[i]);
  return static_cast<double>(top);
}

void SeenPoints::append(const SeenPoints& from, std::size_t i) {
  if (count == kMax) return;
  const std::size_t k = count++;
  x[k] = from.x[i], y[k] = from.y[i], z[k] = from.z[i];
  nx[k] = from.nx[i], ny[k] = from.ny[i], nz[k] = from.nz[i];
  view[k] = from.view[i];
  no_arm[k] = from.no_arm[i];
}

void BodyView::update(const PersonImage& person, std::size_t max_cells) {
  const DepthImage& image = *person.image;
  const DepthCamera& camera = *person.camera;
  std::size_t pixels = 0;
  for (const std::uint8_t p : person.is_person) pixels += p != 0;
  step_ = 1;
  while (pixels / static_cast<std::size_t>(step_ * step_) > max_cells) ++step_;
  width_ = (image.width + step_ - 1) / step_;
  height_ = (image.height + step_ - 1) / step_;
  const double middle = 0.5 * (step_ - 1);
  fx_ = camera.fx / step_;
  fy_ = camera.fy / step_;
  cx_ = (camera.cx - middle) / step_;
  cy_ = (camera.cy - middle) / step_;
  X_WC_ = camera.X_WC;
  X_CW_ = X_WC_.inverse();
  p_WE_ = X_WC_.translation();
  coarsen(image, person.is_person);
  propagateOffsets();
}

void BodyView::coarsen(const DepthImage& image, std::span<const std::uint8_t> is_person) {
  const std::size_t cells = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  state_.assign(cells, CellState::kUnknown);
  z_.assign(cells, 0.0f);
  std::size_t beside = 0, measured = 0;
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      float person = 0.0f, other = 0.0f;
      int persons = 0, others = 0, all = 0;
      for (int y = v * step_; y < std::min((v + 1) * step_, image.height); ++y) {
        for (int x = u * step_; x < std::min((u + 1) * step_, image.width); ++x) {
          const float z = image.at(x, y);
          ++all;
          if (is_person[static_cast<std::size_t>(y * image.width + x)] != 0 && z > 0.0f) {
            // The nearer surface is used if a cell contains two.
            if (persons > 0 && z > person / static_cast<float>(persons) + kSameSurface) continue;
            if (persons > 0 && z < person / static_cast<float>(persons) - kSameSurface)
              person = 0.0f, persons = 0;
            person += z;
            ++persons;
          } else if (z > 0.0f) {
            other += z;
            ++others;
          }
        }
      }
      const std::size_t c = cell(u, v);
      if (persons > 0 && 3 * persons >= all) {
        state_[c] = CellState::kPerson;
        z_[c] = person / static_cast<float>(persons);
        continue;
      }
      ++beside;
      if (others > 0) {
        ++measured;
        z_[c] = other / static_cast<float>(others);
        state_[c] = CellState::kEmpty;
      }
    }
  }
  if (static_cast<double>(measured) < kBareBackground * static_cast<double>(beside))
    for (CellState& s : state_)
      if (s == CellState::kUnknown) s = CellState::kEmpty;
}

// Vector distance transform (Danielsson 1980), four neighbours in two sweeps of two passes: offset to the
// nearest cell of the person, with an error below one cell.
void BodyView::propagateOffsets() {
  offset_to_person_.resize(state_.size());
  for (std::size_t c = 0; c < state_.size(); ++c)
    offset_to_person_[c] = state_[c] == CellState::kPerson ? std::array<std::int16_t, 2>{0, 0}
                                                           : std::array<std::int16_t, 2>{kFar, kFar};
  const auto from = [&](int u, int v, int du, int dv) {
    if (u + du < 0 || u + du >= width_ || v + dv < 0 || v + dv >= height_) return;
    std::array<std::int16_t, 2> w = offset_to_person_[cell(u + du, v + dv)];
    if (w[0] == kFar) return;
    w[0] = static_cast<std::int16_t>(w[0] + du);
    w[1] = static_cast<std::int16_t>(w[1] + dv);
    std::array<std::int16_t, 2>& mine = offset_to_person_[cell(u, v)];
    if (mine[0] == kFar || squared(w) < squared(mine)) mine = w;
  };
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) from(u, v, -1, 0), from(u, v, 0, -1);
    for (int u = width_; u-- > 0;) from(u, v, 1, 0);
  }
  for (int v = height_; v-- > 0;) {
    for (int u = width_; u-- > 0;) from(u, v, 1, 0), from(u, v, 0, 1);
    for (int u = 0; u < width_; ++u) from(u, v, -1, 0);
  }
}

void BodyView::appendPoints(std::uint8_t index, SeenPoints& points) const {
  const std::size_t end = std::min(points.count + kMaxPoints, SeenPoints::kMax);
  const auto point = [&](int u, int v) {
    const double z = z_[cell(u, v)];
    return Vector3d{(u - cx_) / fx_ * z, (v - cy_) / fy_ * z, z};
  };
  const auto smooth = [&](int u, int v, float z) {
    return u >= 0 && u < width_ && v >= 0 && v < height_ && state_[cell(u, v)] == CellState::kPerson &&
           std::abs(z_[cell(u, v)] - z) < kSmooth;
  };
  for (int v = 0; v < height_; ++v) {
    for (int u = 0; u < width_; ++u) {
      const std::size_t c = cell(u, v);
      if (state_[c] != CellState::kPerson || points.count == end) continue;
      const Vector3d p = point(u, v);
      const auto slope = [&](int du, int dv) -> Vector3d {
        const bool next = smooth(u + du, v + dv, z_[c]), last = smooth(u - du, v - dv, z_[c]);
        return (next ? point(u + du, v + dv) : p) - (last ? point(u - du, v - dv) : p);
      };
      const Vector3d view = p.normalized();
      Vector3d n = slope(0, 1).cross(slope(1, 0));
      n = n.norm() > 1e-12 ? n.normalized() : Vector3d(-view);
      if (n.dot(view) > 0.0) n = -n;
      const Vector3f p_W = (X_WC_ * p).cast<float>(), n_W = (X_WC_.linear() * n).cast<float>();
      const std::size_t i = points.count++;
      points.x[i] = p_W.x(), points.y[i] = p_W.y(), points.z[i] = p_W.z();
      points.nx[i] = n_W.x(), points.ny[i] = n_W.y(), points.nz[i] = n_W.z();
      points.view[i] = index;
      points.no_arm[i] = 0.0f;
    }
  }
}

std::optional<Eigen::Vector2d> BodyView::pixelOf(const Vector3d& p_CX) const {
  if (p_CX.z() < 1e-3 || state_.empty()) return std::nullopt;
  const double u = fx_ * p_CX.x() / p_CX.z() + cx_, v = fy_ * p_CX.y() / p_CX.z() + cy_;
  if (!(u > -0.5 && u < width_ - 0.5 && v > -0.5 && v < height_ - 0.5)) return std::nullopt;
  return Eigen::Vector2d(u, v);
}

BodyView::Probe BodyView::at(const Vector3d& p_CX) const {
  Probe probe;
  const std::optional<Eigen::Vector2d> pixel = pixelOf(p_CX);
  if (!pixel) return probe;
  const std::size_t c =
      cell(static_cast<int>(std::lround(pixel->x())), static_cast<int>(std::lround(pixel->y())));
  probe.state = state_[c];
  probe.z = z_[c];
  if (probe.state == CellState::kEmpty && offset_to_person_[c][0] != kFar)
    probe.to_person = {offset_to_person_[c][0] * p_CX.z() / fx_, offset_to_person_[c][1] * p_CX.z() / fy_,
                       0.0};
  return probe;
}

}  // namespace abstand::tracking
