// What a Deformer does to its surface: the start, the iterations of the shape state, and the pose state.
#pragma once

#include "rigless/deform/detail/hard_rows.h"
#include "rigless/deform/detail/local_step.h"
#include "rigless/deform/detail/pose_step.h"
#include "rigless/math/detail/bytes.h"
#include "rigless/math/detail/rotation.h"

namespace rigless::detail {

// A surface that iterates, with all that it needs; V vertices, C controls. The functions are those of Deformer that
// have their names.
template <class S>
struct ShapeIteration {
  using Quad = simd::Quad<S>;

  Cells<S> cells;
  ElasticScale<S> elastic;
  Discs<S> discs;
  HardRows<S> system;
  CellSlices<S> slices;
  std::vector<Vec3<S>> targets;        // C
  std::vector<Mat3<S>> disc_rotation;  // C
  DiscSeams<S> seams;
  std::vector<Quad> moved;   // per held vertex: its last move
  std::vector<char> turned;  // C: the caller has set its rotation
  std::vector<Quad> x;       // V + 1: shape state, in elimination order
  std::vector<Quad> r;       // V + 1: residual, then update
  std::vector<Quad> solved;  // V + 1: the last iterate before momentum carried it on

  // To new cells, without controls. Allocates.
  void bind(S mu);
  // Allocates. On failure the old discs stay. Errors: factorization_failed.
  RIGLESS_COLD Status set_discs(Discs<S> chosen);
  void start(Span<const Mat3<S>> rotations);
  void step(int iterations);
  void relax(int iterations);
  // Leaves in r what the pose state adds to x.
  template <class Law>
  void pose(const Law& law);

  Quad& row(Span<Quad> rows, std::size_t vertex) { return nth(rows, system.place()[vertex]); }
  Vec3<S> position(std::size_t vertex);
  template <bool with_energy>
  double fit_residual();
  void solve_update();
  void unturn_discs(const Mat3<S>& rotation);
  void turn_discs();
  void hold();
  void show(Span<const Quad> update, Span<Vec3<S>> out) const;
  std::int64_t bytes() const;
};

template <class S>
void ShapeIteration<S>::bind(S mu) {
  elastic.mu = mu;
  system.bind(cells);
  slices = slice_cells(cells, system.place(), system.vertex_at());
  discs = {};
  seams = {};
  discs.owner.assign(cells.size(), -1);
  targets.clear();
  disc_rotation.clear();
  turned.clear();
  for (auto* rows : {&x, &r, &solved}) rows->assign(cells.size() + 1, Quad{});
}

template <class S>
Status ShapeIteration<S>::set_discs(Discs<S> chosen) {
  if (const Status s = system.hold(cells, discs, chosen); !s.ok()) return s;
  discs = std::move(chosen);
  seams = find_seams(cells, discs);
  moved.assign(discs.member.size(), Quad{});
  targets = discs.center;
  disc_rotation.assign(discs.size(), Mat3<S>::Identity());
  turned.assign(discs.size(), 0);
  return {};
}

template <class S>
void ShapeIteration<S>::start(Span<const Mat3<S>> rotations) {
  RIGLESS_ASSERT(discs.size() > 0);
  Vec3<S> from = Vec3<S>::Zero(), to = Vec3<S>::Zero();
  for (std::size_t c = 0; c < targets.size(); ++c) {
    from += discs.center[c];
    to += targets[c];
  }
  from /= static_cast<S>(targets.size());
  to /= static_cast<S>(targets.size());
  Mat3<S> C = Mat3<S>::Zero();
  for (std::size_t c = 0; c < targets.size(); ++c) {
    C += (discs.center[c] - from) * (targets[c] - to).transpose();
  }
  const auto set = std::find(turned.begin(), turned.end(), char(1));
  const Mat3<S> R =
      set != turned.end() ? disc_rotation[static_cast<std::size_t>(set - turned.begin())] : nearest_rotation(C);
  for (std::size_t v = 0; v < cells.size(); ++v) {
    const Vec3<S> p = to + R * (cells.rest[v] - from);
    row(x, v) = Quad{p.x(), p.y(), p.z(), S(0)};
  }
  unturn_discs(R);
  slices.set_rotations(R);
  std::fill(r.begin(), r.end(), Quad{});  // a rigidly moved surface has no residual; what is held has moved on
  if (!rotations.empty()) {
    for (std::size_t v = 0; v < cells.size(); ++v) slices.set_rotation(system.place()[v], rotations[v]);
    for (std::size_t c = 0; c < discs.size(); ++c)
      if (!turned[c]) disc_rotation[c] = nth(rotations, nth(discs.member, discs.first[c]));
    turned_step(slices, x.data(), r.data());
  }
  hold();
  system.solve(r.data());
  for (std::size_t i = 0; i < cells.size(); ++i) x[i] += r[i];
}

template <class S>
void ShapeIteration<S>::step(int iterations) {
  RIGLESS_ASSERT(discs.size() > 0);
  for (int it = 0; it < iterations; ++it) {
    fit_residual<false>();
    solve_update();
  }
}

template <class S>
void ShapeIteration<S>::relax(int iterations) {
  RIGLESS_ASSERT(discs.size() > 0);
  double accepted = std::numeric_limits<double>::infinity();
  double pace = 1;
  bool ahead = false;
  for (int it = 0; it < iterations; ++it) {
    double energy = fit_residual<true>();
    if (ahead && energy > accepted) {
      std::copy(solved.begin(), solved.end(), x.begin());
      energy = fit_residual<true>();
      pace = 1;
    }
    accepted = energy;
    solve_update();
    const double next = (1 + std::sqrt(1 + 4 * pace * pace)) / 2;
    const S momentum = static_cast<S>((pace - 1) / next);
    pace = next;
    ahead = momentum > S(0) && it + 1 < iterations;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Quad now = x[i];
      if (ahead) x[i] += momentum * (now - solved[i]);
      solved[i] = now;
    }
    for (const std::int32_t v : discs.member) row(x, to_size(v)) = row(solved, to_size(v));
  }
}

// Local step at x into r.
template <class S>
template <bool with_energy>
double ShapeIteration<S>::fit_residual() {
  std::fill(r.begin(), r.end(), Quad{});
  return shape_step<with_energy>(slices, x.data(), elastic, r.data());
}

// Discs, then the free vertices.
template <class S>
void ShapeIteration<S>::solve_update() {
  turn_discs();
  hold();
  system.solve(r.data());
  for (std::size_t i = 0; i < cells.size(); ++i) x[i] += r[i];
}

template <class S>
template <class Law>
void ShapeIteration<S>::pose(const Law& law) {
  RIGLESS_ASSERT(discs.size() > 0);
  std::fill(r.begin(), r.end(), Quad{});
  pose_step(slices, x.data(), law, r.data());
  for (const std::int32_t v : discs.member) row(r, to_size(v)) = Quad{};
  system.solve(r.data());
}

template <class S>
Vec3<S> ShapeIteration<S>::position(std::size_t vertex) {
  const Quad& q = row(x, vertex);
  return {q[0], q[1], q[2]};
}

// Where free discs begin.
template <class S>
void ShapeIteration<S>::unturn_discs(const Mat3<S>& rotation) {
  for (std::size_t c = 0; c < discs.size(); ++c) {
    if (!turned[c]) disc_rotation[c] = rotation;
  }
}

template <class S>
void ShapeIteration<S>::turn_discs() {
  for (std::size_t c = 0; c < discs.size(); ++c) {
    if (turned[c] || discs.first[c + 1] - discs.first[c] < 2) continue;  // a single vertex has no turn
    disc_rotation[c] = fit_disc<S>(
        seams, discs, c, [&](std::size_t v) { return slices.transform(system.place()[v]); },
        [&](std::size_t v) { return position(v); }, targets[c]);
  }
}

// Puts held vertices where target and disc have them. Their free neighbours' residuals learn of the move; their own are
// settled.
template <class S>
void ShapeIteration<S>::hold() {
  for (std::size_t c = 0; c < discs.size(); ++c) {
    const Vec3<S>& center = discs.center[c];
    for (std::int32_t m = discs.first[c]; m < discs.first[c + 1]; ++m) {
      const auto v = to_size(nth(discs.member, m));
      const Vec3<S> p = targets[c] + disc_rotation[c] * (cells.rest[v] - center);
      const Quad now{p.x(), p.y(), p.z(), S(0)};
      nth(moved, m) = now - row(x, v);
      row(x, v) = now;
    }
  }
  for (const auto& edge : seams.edge) {
    row(r, to_size(edge.to)) += edge.weight * nth(moved, edge.member);
  }
  for (const std::int32_t v : discs.member) row(r, to_size(v)) = Quad{};
}

// x, plus the update if there is one, in the caller's numbering.
template <class S>
void ShapeIteration<S>::show(Span<const Quad> update, Span<Vec3<S>> out) const {
  for (std::size_t v = 0; v < out.size(); ++v) {
    const auto at = to_size(system.place()[v]);
    const Quad q = update.empty() ? x[at] : x[at] + update[at];
    out[v] = Vec3<S>(q[0], q[1], q[2]);
  }
}

template <class S>
std::int64_t ShapeIteration<S>::bytes() const {
  return system.bytes() + slices.bytes() +
         bytes_of(cells.ring.first, cells.ring.neighbor, cells.weight, cells.rest, cells.weighted_size, discs.owner,
                  discs.member, x, r, solved);
}

}  // namespace rigless::detail
