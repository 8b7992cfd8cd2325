// The cells once more, laid out for the machine: in elimination order, and as many side by side as a register has
// lanes.
#pragma once

#include "rigless/deform/detail/cells.h"
#include "rigless/math/detail/bytes.h"
#include "rigless/math/detail/rotation_lanes.h"

namespace rigless::detail {

// A slice is `width` cells; slot k of a slice holds edge k of each. Inside windows of 512 cells the ones with equally
// many neighbours share slices, so that few slots are padding. Padding edges have weight 0 and point at their own cell;
// padding cells point at row n, which nothing reads.
// Source: SELL-C-sigma, Kreutzer et al. 2014.
template <class S>
struct CellSlices {
  using L = simd::Lanes<S>;
  static constexpr int width = simd::width<S>;

  struct Slot {
    L wx, wy, wz;  // w e
    L w;
  };
  struct Cell {
    QuaternionLanes<S> q = {};  // warm start of the rotation
    L scale = {};               // s of the last step
    L inverse_size = {};        // 1 / sum w |e|^2
    L size = {};
    L idle = {};       // 1 where there is nothing to fit
    L pull[3] = {};    // sum w e
    L moment[6] = {};  // sum w e e^T: xx, xy, xz, yy, yz, zz
  };

  std::vector<Cell> cell;            // slices
  std::vector<simd::RowOffset> row;  // slices x width: of x and r
  std::vector<std::int32_t> first;   // slices + 1: into slot
  std::vector<Slot> slot;
  std::vector<simd::RowOffset> other;  // slots x width: row of the neighbour
  std::vector<std::int32_t> lane_of;   // n: place -> slice * width + lane
  std::vector<L> inverse_weight;       // slots; 0 for padding
  std::vector<L> edges;                // scratch: 3 per slot of the longest slice, for two slices

  std::size_t size() const { return cell.size(); }

  // Room for the present edges of slice s, until those of slice s + 2.
  L* edges_of(std::size_t s) { return edges.data() + s % 2 * (edges.size() / 2); }

  // s R of the cell at `place`, as last fitted.
  Mat3<S> transform(std::int32_t place_of) const {
    const auto at = static_cast<std::size_t>(lane_of[static_cast<std::size_t>(place_of)]);
    const Cell& c = cell[at / width];
    const int k = static_cast<int>(at % width);
    return c.scale[k] * Eigen::Quaternion<S>(c.q.w[k], c.q.x[k], c.q.y[k], c.q.z[k]).toRotationMatrix();
  }

  void set_rotation(std::int32_t place_of, const Mat3<S>& R) {
    const auto at = to_size(nth(lane_of, place_of));
    detail::set_rotation(R, static_cast<int>(at % width), cell[at / width].q);
  }

  void set_rotations(const Mat3<S>& R) {
    for (Cell& c : cell) {
      for (int k = 0; k < width; ++k) detail::set_rotation(R, k, c.q);
    }
  }

  std::int64_t bytes() const { return bytes_of(cell, row, first, slot, other, inverse_weight, lane_of, edges); }
};

// Lays the cells out. place_of: vertex -> row. Allocates.
template <class S>
RIGLESS_COLD CellSlices<S> slice_cells(const Cells<S>& cells, const std::vector<std::int32_t>& place_of,
                                       const std::vector<std::int32_t>& vertex_at) {
  constexpr std::size_t window = 512;
  using Out = CellSlices<S>;
  using L = typename Out::L;
  constexpr auto width = static_cast<std::size_t>(Out::width);
  Out out;
  const std::size_t n = cells.size();
  const auto valence = [&](std::int32_t v) {
    return cells.ring.first[static_cast<std::size_t>(v) + 1] - cells.ring.first[static_cast<std::size_t>(v)];
  };
  std::vector<std::int32_t> order = vertex_at;
  for (std::size_t b = 0; b < n; b += window) {
    std::stable_sort(order.begin() + static_cast<std::ptrdiff_t>(b),
                     order.begin() + static_cast<std::ptrdiff_t>(std::min(n, b + window)),
                     [&](std::int32_t a, std::int32_t c) { return valence(a) > valence(c); });
  }
  out.lane_of.resize(n);
  out.first.push_back(0);
  std::size_t longest = 0;
  for (std::size_t b = 0; b < n; b += width) {
    std::int32_t slots = 0;
    for (std::size_t k = b; k < std::min(n, b + width); ++k) slots = std::max(slots, valence(order[k]));
    longest = std::max(longest, static_cast<std::size_t>(slots));
    const std::size_t slot0 = out.slot.size();
    out.slot.resize(slot0 + static_cast<std::size_t>(slots), {L{}, L{}, L{}, L{}});
    out.inverse_weight.resize(out.slot.size(), L{});
    out.first.push_back(static_cast<std::int32_t>(out.slot.size()));
    out.cell.emplace_back();
    auto& cell = out.cell.back();
    cell.q = {simd::splat<L>(S(1)), L{}, L{}, L{}};
    cell.scale = simd::splat<L>(S(1));
    for (std::size_t k = 0; k < width; ++k) {
      const int lane = static_cast<int>(k);
      const bool padding = b + k >= n;
      const std::int32_t place =
          padding ? static_cast<std::int32_t>(n) : place_of[static_cast<std::size_t>(order[b + k])];
      out.row.push_back(simd::row_offset<S>(place));
      const S size = padding ? S(0) : cells.weighted_size[static_cast<std::size_t>(order[b + k])];
      cell.size[lane] = size;
      cell.inverse_size[lane] = size > S(0) ? S(1) / size : S(0);
      cell.idle[lane] = size > S(0) ? S(0) : S(1);
      out.other.resize(out.slot.size() * width);
      std::size_t s = slot0;
      if (!padding) {
        out.lane_of[static_cast<std::size_t>(place)] = static_cast<std::int32_t>((out.cell.size() - 1) * width + k);
        for_each_edge(cells, static_cast<std::size_t>(order[b + k]), [&](S w, const Vec3<S>& e, std::size_t j) {
          auto& slot = out.slot[s];
          slot.wx[lane] = w * e.x();
          slot.wy[lane] = w * e.y();
          slot.wz[lane] = w * e.z();
          slot.w[lane] = w;
          out.inverse_weight[s][lane] = S(1) / w;
          out.other[s * width + k] = simd::row_offset<S>(place_of[j]);
          const S moment[6] = {e.x() * e.x(), e.x() * e.y(), e.x() * e.z(),
                               e.y() * e.y(), e.y() * e.z(), e.z() * e.z()};
          for (int a = 0; a < 3; ++a) cell.pull[a][lane] += w * e[a];
          for (int a = 0; a < 6; ++a) cell.moment[a][lane] += w * moment[a];
          ++s;
        });
      }
      for (; s < out.slot.size(); ++s) out.other[s * width + k] = simd::row_offset<S>(place);
    }
  }
  out.edges.resize(2 * 3 * longest);
  return out;
}

}  // namespace rigless::detail
