// How large a model is when debris far away does not count.
#pragma once

#include "rigless/mesh/detail/voxel_grid.h"

namespace rigless::detail {

// Weights along an axis: corners of triangles, each with its share of the area.
struct WeightAlong {
  std::vector<double> at, weight;

  // The narrowest range outside of which lies `share` of the weight, on each side: bins, of which the ones at the ends
  // are divided again. Finds nothing where there is no weight.
  void trim(double share, double& low, double& high) const {
    constexpr int bins = 1024;
    double total = 0;
    for (const double w : weight) total += w;
    for (int round = 0; round < 4 && high > low && total > 0; ++round) {
      std::array<double, bins> sum{};
      double below = 0, above = 0;
      const double width = (high - low) / bins;
      for (std::size_t k = 0; k < at.size(); ++k) {
        const double place = (at[k] - low) / width;
        if (place < 0) {
          below += weight[k];
        } else if (place > bins) {
          above += weight[k];
        } else {
          nth(sum, std::min(bins - 1, static_cast<int>(place))) += weight[k];
        }
      }
      int first = 0, last = bins - 1;
      while (first < last && below + nth(sum, first) <= share * total) below += nth(sum, first++);
      while (last > first && above + nth(sum, last) <= share * total) above += nth(sum, last--);
      high = low + width * (last + 1);
      low += width * first;
      if (last - first > bins / 2) return;
    }
  }
};

// The box of the vertices that faces use, those marked in `left_out` aside; cut where the box of all but a
// `share` of the area to each side, grown by half its longest side, ends. Allocates.
template <class S>
RIGLESS_COLD Box body_box(Span<const Vec3<S>> vertices, Span<const Face> faces, const std::vector<char>& left_out,
                          double share = 0.002) {
  Box box;
  bool any = false;
  std::array<WeightAlong, 3> along;
  const std::size_t stride = faces.size() / 65536 + 1, most_corners = 3 * (faces.size() / stride + 1);
  for (WeightAlong& one : along) {
    one.at.reserve(most_corners);
    one.weight.reserve(most_corners);
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!left_out.empty() && left_out[f]) continue;
    Point corner[3];
    for (std::size_t k = 0; k < 3; ++k) corner[k] = nth(vertices, faces[f][k]).template cast<double>();
    if (!any) box = {corner[0], corner[0]};
    any = true;
    for (const Point& p : corner) box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
    if (f % stride != 0) continue;
    const double area = (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
    for (std::size_t a = 0; a < 3; ++a) {
      for (const Point& p : corner) {
        along[a].at.push_back(p[static_cast<int>(a)]);
        along[a].weight.push_back(area);
      }
    }
  }
  Box most = box;
  for (std::size_t a = 0; a < 3; ++a)
    along[a].trim(share, most.low[static_cast<int>(a)], most.high[static_cast<int>(a)]);
  const double room = (most.high - most.low).maxCoeff() / 2;
  return {box.low.cwiseMax((most.low.array() - room).matrix()), box.high.cwiseMin((most.high.array() + room).matrix())};
}

}  // namespace rigless::detail
