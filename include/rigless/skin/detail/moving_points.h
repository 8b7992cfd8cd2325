// A mesh and its frames as the points that a skin is fitted to: seams closed, the whole body's motion taken out.
#pragma once

#include <cmath>

#include "rigless/math/status.h"
#include "rigless/mesh/detail/measure.h"
#include "rigless/mesh/detail/one_ring.h"
#include "rigless/mesh/detail/weld.h"
#include "rigless/skin/detail/frame_pose.h"

namespace rigless::detail {

// begin(), add_frame(), then gather(); what follows counts in points. V vertices, F frames.
template <class S>
class MovingPoints {
 public:
  std::vector<std::int32_t> of_vertex;  // V: its point
  std::vector<Vec3<double>> rest;       // of points
  std::vector<Face> faces;              // of points
  OneRing ring;
  std::vector<RigidMotion> roots;   // F: what the whole body does
  std::vector<std::size_t> looked;  // frames that are looked at, F at most
  std::size_t step = 1;             // every so manieth
  double diagonal = 0;              // of the box at rest

  std::int32_t count() const { return count_of(rest); }

  // Errors: empty_input; index_out_of_range (face); not_finite (vertex).
  Status begin(Span<const Vec3<S>> vertices, Span<const Face> of) {
    if (vertices.empty()) return {Error::empty_input, -1};
    if (!of.empty()) {
      if (const Status s = check_faces(of, count_of(vertices)); !s.ok()) return s;
    }
    if (const Status s = check_finite(vertices); !s.ok()) return s;
    *this = MovingPoints();
    vertices_.assign(vertices.begin(), vertices.end());
    faces.assign(of.begin(), of.end());
    of_vertex = weld<S>(vertices_);
    diagonal = static_cast<double>(bounds<S>(vertices).diagonal());
    return {};
  }

  // `whole`: the body's rigid motion is taken out. Errors: size_mismatch; not_finite (vertex).
  Status add_frame(Span<const Vec3<S>> positions, bool whole = true) {
    if (positions.size() != vertices_.size()) return {Error::size_mismatch, -1};
    if (const Status s = check_finite(positions); !s.ok()) return s;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      if (positions[v] != nth(positions, of_vertex[v])) of_vertex[v] = static_cast<std::int32_t>(v);
    }
    const auto from = [&](std::int32_t v) { return wide(nth(vertices_, v)); };
    const auto to = [&](std::int32_t v) { return wide(positions[v]); };
    roots.push_back(whole ? nearest_rigid_motion(count_of(vertices_), from, to) : RigidMotion());
    frames_.emplace_back(positions.begin(), positions.end());
    return {};
  }

  void gather(std::int32_t most_frames) {
    std::vector<std::int32_t> point(vertices_.size());
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      if (of_vertex[v] == static_cast<std::int32_t>(v)) {
        point[v] = count();
        vertex_.push_back(v);
        rest.push_back(wide(vertices_[v]));
      }
      point[v] = nth(point, of_vertex[v]);
    }
    of_vertex = std::move(point);
    std::vector<std::array<std::int32_t, 2>> pairs;
    for (Face& f : faces) {
      for (std::int32_t& v : f) v = nth(of_vertex, v);
      for (int k = 0; k < 3; ++k) {
        if (nth(f, k) != nth(f, (k + 1) % 3)) pairs.push_back({nth(f, k), nth(f, (k + 1) % 3)});
      }
    }
    ring = one_ring_from_pairs(pairs, count());
    step = (roots.size() + to_size(most_frames) - 1) / to_size(most_frames);
    for (std::size_t f = 0; f < roots.size(); f += step) looked.push_back(f);
  }

  // Where point i is in frame f before the root moves it.
  Vec3<double> now(std::size_t f, std::int32_t i) const { return roots[f].back(wide(frames_[f][nth(vertex_, i)])); }

  // 3F x many: how points leave their places at rest in the frames that are looked at.
  SkinMatrix ways(Span<const std::int32_t> points) const {
    SkinMatrix Y(3 * static_cast<Eigen::Index>(looked.size()), static_cast<Eigen::Index>(points.size()));
    for (std::size_t k = 0; k < looked.size(); ++k) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        Y.template block<3, 1>(static_cast<Eigen::Index>(3 * k), static_cast<Eigen::Index>(i)) =
            now(looked[k], points[i]) - nth(rest, points[i]);
      }
    }
    return Y;
  }

 private:
  static Vec3<double> wide(const Vec3<S>& p) { return p.template cast<double>(); }

  static Status check_finite(Span<const Vec3<S>> points) {
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (!std::isfinite(points[v].squaredNorm())) return {Error::not_finite, v};
    }
    return {};
  }

  std::vector<Vec3<S>> vertices_;
  std::vector<std::vector<Vec3<S>>>
      frames_;                       // each on its own: as one they would be moved, and twice there, as they grow
  std::vector<std::size_t> vertex_;  // one of each point
};

}  // namespace rigless::detail
