// Whether a shape is its own mirror image, and in which plane.
#pragma once

#include <cmath>
#include <limits>

#include "rigless/math/detail/svd3.h"
#include "rigless/mesh/detail/measure.h"
#include "rigless/mesh/detail/shape_facts.h"
#include "rigless/mesh/detail/shells.h"

namespace rigless::detail {

// `count` points spread evenly over F faces, the same each time; the vertices where the faces have no area. Allocates.
template <class S>
std::vector<Vec3<S>> surface_samples(Span<const Vec3<S>> vertices, Span<const Face> faces, std::size_t count) {
  std::vector<Vec3<S>> samples;
  const S total = surface_area(vertices, faces);
  if (!(total > S(0)) || !std::isfinite(total)) {
    samples.assign(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(std::min(count, vertices.size())));
    return samples;
  }
  samples.reserve(count);
  S owed = S(0.5);
  for (const Face& f : faces) {
    const Vec3<S>& a = nth(vertices, f[0]);
    const Vec3<S> u = nth(vertices, f[1]) - a, v = nth(vertices, f[2]) - a;
    for (owed += u.cross(v).norm() / S(2) / total * static_cast<S>(count); owed >= S(1); owed -= S(1)) {
      // The R2 sequence: successive points keep away from each other.
      const auto n = static_cast<S>(samples.size());
      S s = S(0.5) + S(0.754877666) * n, t = S(0.5) + S(0.569840291) * n;
      s -= std::floor(s);
      t -= std::floor(t);
      if (s + t > S(1)) {
        s = S(1) - s;
        t = S(1) - t;
      }
      samples.push_back(a + s * u + t * v);
    }
  }
  return samples;
}

// Source: candidates from the principal directions, Minovic, Ishikawa, Kato 1993.
template <class S>
class SymmetryFinder {
 public:
  // M samples of a surface, which must stay. Allocates.
  explicit SymmetryFinder(Span<const Vec3<S>> samples)
      : samples_(samples),
        box_(bounds(samples)),
        reach_(std::max(box_.diagonal() / S(20), std::numeric_limits<S>::min())),
        grid_(samples, reach_) {
    for (const Vec3<S>& p : samples) center_ += p / static_cast<S>(samples.size());
  }

  // The plane that fits best among those of the axes and of the principal directions, turned and moved until it fits
  // no better. What is equally good goes to the axis that comes first, x, then z. Of two that fit well the one across
  // which tips of the body lie in pairs is preferred: arms are left and right; and the one across `left`, where the
  // file is known to have that on the body's left. No allocation.
  SymmetryPlane<S> best(Span<const Vec3<S>> tips, const Vec3<S>& left = Vec3<S>::Zero()) const {
    SymmetryPlane<S> best;
    Mat3<S> spread = Mat3<S>::Zero();
    for (const Vec3<S>& p : samples_) spread += (p - center_) * (p - center_).transpose();
    const Mat3<S> principal = svd3(spread).V;
    S least = std::numeric_limits<S>::max();
    for (int k = 0; k < 6; ++k) {
      const Vec3<S> axis = k < 3 ? Vec3<S>::Unit(2 * k % 3) : Vec3<S>(principal.col(k - 3));
      SymmetryPlane<S> candidate = measured(k < 3 ? middle() : center_, axis);
      if (candidate.misfit > S(0.035)) continue;
      candidate = refined(candidate);
      const S cost = candidate.misfit - (pairs_tips(candidate, tips) ? S(0.01) : S(0)) -
                     (std::abs(candidate.normal.dot(left)) > S(0.9) ? S(0.02) : S(0));
      if (cost >= least - S(0.002)) continue;
      least = cost;
      best = candidate;
    }
    return best;
  }

  // The one that fits best of those about across an axis. No allocation.
  SymmetryPlane<S> across(const Vec3<S>& axis) const { return refined(measured(middle(), axis)); }

 private:
  Vec3<S> middle() const { return (box_.low + box_.high) / S(2); }

  // The two ends of what is longest across the plane are no limbs.
  bool pairs_tips(const SymmetryPlane<S>& plane, Span<const Vec3<S>> tips) const {
    const Vec3<S> across = plane.normal.cwiseAbs().cwiseProduct(box_.extent());
    if (across.maxCoeff() > S(0.99) * box_.extent().maxCoeff()) return false;
    for (const Vec3<S>& a : tips) {
      if (std::abs(plane.side(a)) < S(0.08) * box_.diagonal()) continue;
      for (const Vec3<S>& b : tips)
        if ((plane.mirror(a) - b).norm() < S(0.14) * box_.diagonal()) return true;
    }
    return false;
  }

  // A plane in which nearly all of the mesh lies says nothing.
  SymmetryPlane<S> measured(const Vec3<S>& point, const Vec3<S>& normal) const {
    SymmetryPlane<S> plane{point, normal.normalized()};
    if (samples_.empty() || !(box_.diagonal() > S(0))) return plane;
    const std::size_t stride = std::max<std::size_t>(1, samples_.size() / 400);
    S sum = 0, off = 0, count = 0;
    for (std::size_t i = 0; i < samples_.size(); i += stride, count += S(1)) {
      const Vec3<S> image = plane.mirror(samples_[i]);
      const std::int32_t to = grid_.nearest(image, 1, [](std::int32_t) { return true; });
      sum += to < 0 ? S(2) * reach_ : std::min(S(2) * reach_, (nth(samples_, to) - image).norm());
      off += std::abs(plane.side(samples_[i]));
    }
    if (off / count > S(0.02) * box_.diagonal()) plane.misfit = sum / count / box_.diagonal();
    return plane;
  }

  SymmetryPlane<S> refined(SymmetryPlane<S> best) const {
    for (S step = S(0.04); step > S(0.004) && best.misfit > S(0.008); step /= S(2)) {
      const Vec3<S> u = best.normal.unitOrthogonal(), v = best.normal.cross(u);
      const SymmetryPlane<S> start = best;
      for (const S sign : {S(1), S(-1)}) {
        for (const SymmetryPlane<S>& moved :
             {measured(start.point, start.normal + sign * step * u),
              measured(start.point, start.normal + sign * step * v),
              measured(start.point + sign * step / S(4) * box_.diagonal() * start.normal, start.normal)}) {
          if (moved.misfit < best.misfit * S(0.97)) best = moved;
        }
      }
    }
    return best;
  }

  Span<const Vec3<S>> samples_;
  Bounds<S> box_;
  S reach_;
  PointGrid<S> grid_;
  Vec3<S> center_ = Vec3<S>::Zero();
};

}  // namespace rigless::detail
