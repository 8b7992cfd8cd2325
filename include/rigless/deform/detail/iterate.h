// What a Deformer does to its surface: the start, the iterations of the shape state, and the pose state.
#pragma once

#include "rigless/deform/deformer.h"

namespace rigless {

template <class S, class Weights>
void Deformer<S, Weights>::start() {
  RIGLESS_ASSERT(discs_.size() > 0);
  Vec3<S> from = Vec3<S>::Zero(), to = Vec3<S>::Zero();
  for (std::size_t c = 0; c < targets_.size(); ++c) {
    from += discs_.center[c];
    to += targets_[c];
  }
  from /= static_cast<S>(targets_.size());
  to /= static_cast<S>(targets_.size());
  Mat3<S> C = Mat3<S>::Zero();
  for (std::size_t c = 0; c < targets_.size(); ++c) {
    C += (discs_.center[c] - from) * (targets_[c] - to).transpose();
  }
  const Mat3<S> R = nearest_rotation(C);
  for (std::size_t v = 0; v < cells_.size(); ++v) {
    const Vec3<S> p = to + R * (cells_.rest[v] - from);
    row(x_, v) = Quad{p.x(), p.y(), p.z(), S(0)};
  }
  unturn_discs(R);
  slices_.set_rotations(R);
  std::fill(r_.begin(), r_.end(), Quad{});  // a rigidly moved surface has no residual; what is held has moved on
  hold();
  system_.solve(r_.data());
  for (std::size_t i = 0; i < cells_.size(); ++i) x_[i] += r_[i];
  show({}, shape_);
}

template <class S, class Weights>
void Deformer<S, Weights>::step(int iterations) {
  RIGLESS_ASSERT(discs_.size() > 0);
  for (int it = 0; it < iterations; ++it) {
    fit_residual<false>();
    solve_update();
  }
  show({}, shape_);
}

template <class S, class Weights>
void Deformer<S, Weights>::relax(int iterations) {
  RIGLESS_ASSERT(discs_.size() > 0);
  double accepted = std::numeric_limits<double>::infinity();
  double pace = 1;
  bool ahead = false;
  for (int it = 0; it < iterations; ++it) {
    double energy = fit_residual<true>();
    if (ahead && energy > accepted) {
      std::copy(solved_.begin(), solved_.end(), x_.begin());
      energy = fit_residual<true>();
      pace = 1;
    }
    accepted = energy;
    solve_update();
    const double next = (1 + std::sqrt(1 + 4 * pace * pace)) / 2;
    const S momentum = static_cast<S>((pace - 1) / next);
    pace = next;
    ahead = momentum > S(0) && it + 1 < iterations;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Quad now = x_[i];
      if (ahead) x_[i] += momentum * (now - solved_[i]);
      solved_[i] = now;
    }
    for (const std::int32_t v : discs_.member) row(x_, to_size(v)) = row(solved_, to_size(v));
  }
  show({}, shape_);
}

// Local step at x into r.
template <class S, class Weights>
template <bool with_energy>
double Deformer<S, Weights>::fit_residual() {
  std::fill(r_.begin(), r_.end(), Quad{});
  return shape_step<with_energy>(slices_, x_.data(), elastic_, r_.data());
}

// Discs, then the free vertices.
template <class S, class Weights>
void Deformer<S, Weights>::solve_update() {
  turn_discs();
  hold();
  system_.solve(r_.data());
  for (std::size_t i = 0; i < cells_.size(); ++i) x_[i] += r_[i];
}

template <class S, class Weights>
template <class Law, std::enable_if_t<std::is_class_v<Law>, int>>
void Deformer<S, Weights>::pose(const Law& law) {
  RIGLESS_ASSERT(discs_.size() > 0);
  std::fill(r_.begin(), r_.end(), Quad{});
  pose_step(slices_, x_.data(), law, r_.data());
  for (const std::int32_t v : discs_.member) row(r_, to_size(v)) = Quad{};
  system_.solve(r_.data());
  show(r_, positions_);
}

template <class S, class Weights>
Vec3<S> Deformer<S, Weights>::position(std::size_t vertex) {
  const Quad& q = row(x_, vertex);
  return {q[0], q[1], q[2]};
}

template <class S, class Weights>
void Deformer<S, Weights>::turn_discs() {
  for (std::size_t c = 0; c < discs_.size(); ++c) {
    if (turned_[c] || discs_.first[c + 1] - discs_.first[c] < 2) continue;  // a single vertex has no turn
    disc_rotation_[c] = fit_disc<S>(
        seams_, discs_, c, [&](std::size_t v) { return slices_.transform(system_.place()[v]); },
        [&](std::size_t v) { return position(v); }, targets_[c]);
  }
}

// Puts held vertices where target and disc have them. Their free neighbours' residuals learn of the move; their own are
// settled.
template <class S, class Weights>
void Deformer<S, Weights>::hold() {
  for (std::size_t c = 0; c < discs_.size(); ++c) {
    const Vec3<S>& center = discs_.center[c];
    for (std::int32_t m = discs_.first[c]; m < discs_.first[c + 1]; ++m) {
      const auto v = to_size(nth(discs_.member, m));
      const Vec3<S> p = targets_[c] + disc_rotation_[c] * (cells_.rest[v] - center);
      const Quad now{p.x(), p.y(), p.z(), S(0)};
      nth(moved_, m) = now - row(x_, v);
      row(x_, v) = now;
    }
  }
  for (const auto& edge : seams_.edge) {
    row(r_, to_size(edge.to)) += edge.weight * nth(moved_, edge.member);
  }
  for (const std::int32_t v : discs_.member) row(r_, to_size(v)) = Quad{};
}

// x, plus the update if there is one, in the caller's numbering.
template <class S, class Weights>
void Deformer<S, Weights>::show(Span<const Quad> update, Span<Vec3<S>> out) const {
  for (std::size_t v = 0; v < out.size(); ++v) {
    const auto at = to_size(system_.place()[v]);
    const Quad q = update.empty() ? x_[at] : x_[at] + update[at];
    out[v] = Vec3<S>(q[0], q[1], q[2]);
  }
}

}  // namespace rigless
