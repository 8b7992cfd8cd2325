// The pose state: where the shape state stretched a cell along one axis, squeeze it across, so that volume is kept.
#pragma once

#include "rigless/deform/cells.h"

namespace rigless {

// s' = s^lambda_v: equal to the thesis' Eq 3.12 to first order, and positive for every squash, where the linear law
// turns negative below s = 1 - 1 / lambda_v.
template <class S>
struct PowerLaw {
  S lambda_v = S(1);
  S lowest = S(0.25);
  S highest = S(4);

  S operator()(S s) const {
    return std::min(std::max(std::pow(std::max(s, std::numeric_limits<S>::min()), lambda_v), lowest), highest);
  }
};

// Primary axis and stretch of one cell.
template <class S>
struct Stretch {
  Vec3<S> axis;
  S s = S(1);
  bool defined = false;  // false for an undeformed cell
};

// Axis: the largest principal component of the edge differences d = e' - R e (weighted in both). Stretch: the scale
// that best explains the edges projected on it. Source: thesis Eq 3.9 and 3.11.
template <class S>
Stretch<S> fit_stretch(const Cells<S>& cells, Span<const Vec3<S>> surface, const Mat3<S>& R, std::size_t i) {
  Mat3<S> D = Mat3<S>::Zero();
  for_each_edge(cells, i, [&](S w, const Vec3<S>& e, std::size_t j) {
    const Vec3<S> d = (surface[i] - surface[j]) - R * e;
    D.noalias() += (w * d) * d.transpose();
  });
  const Svd3<S> svd = svd3(D);
  Stretch<S> stretch;
  if (!(svd.sigma[0] > S(1e-12) * cells.weighted_size[i])) return stretch;
  stretch.axis = svd.U.col(0);
  const Vec3<S> rest_axis = R.transpose() * stretch.axis;
  S numerator = S(0), denominator = S(0);
  for_each_edge(cells, i, [&](S w, const Vec3<S>& e, std::size_t j) {
    const S along = rest_axis.dot(e);
    numerator += w * stretch.axis.dot(surface[i] - surface[j]) * along;
    denominator += w * along * along;
  });
  if (!(denominator > S(1e-12) * cells.weighted_size[i])) return stretch;
  stretch.s = numerator / denominator;
  stretch.defined = true;
  return stretch;
}

// V_i R_i, V_i = P diag(1, s'^-1/2, s'^-1/2) P^T. Source: thesis Eq 3.8 (as configured there) and 3.10.
template <class S, class Law>
Mat3<S> volume_transform(const Stretch<S>& stretch, const Mat3<S>& R, const Law& law) {
  if (!stretch.defined) return R;
  const S across = S(1) / std::sqrt(law(stretch.s));
  return across * R + (S(1) - across) * stretch.axis * (stretch.axis.transpose() * R);
}

}  // namespace rigless
