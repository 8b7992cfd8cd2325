// What is fitted to a single cell: the local step as the paper has it, one cell at a time.
#pragma once

#include <cmath>

#include "rigless/deform/detail/cells.h"
#include "rigless/math/detail/rotation.h"

namespace rigless {

// sum_j w_ij e_ij e'_ij^T. Source: thesis Eq 3.3.
template <class S>
Mat3<S> covariance(const Cells<S>& cells, Span<const Vec3<S>> surface, std::size_t i) {
  Mat3<S> C = Mat3<S>::Zero();
  detail::for_each_edge(cells, i, [&](S w, const Vec3<S>& e, std::size_t j) {
    C.noalias() += (w * e) * (surface[i] - surface[j]).transpose();
  });
  return C;
}

// Rotation and scale of cell i on this surface.
template <class S>
struct CellFit {
  Mat3<S> R;
  S s;
};

template <class S>
CellFit<S> fit_cell(const Cells<S>& cells, Span<const Vec3<S>> surface, std::size_t i,
                    const detail::ElasticScale<S>& elastic) {
  const Mat3<S> C = covariance(cells, surface, i);
  CellFit<S> fit{detail::nearest_rotation(C), S(1)};
  if (cells.weighted_size[i] > S(0)) {
    fit.s = elastic((fit.R.cwiseProduct(C.transpose())).sum() / cells.weighted_size[i]);  // tr(R C) = e'.e^r
  }
  return fit;
}

// Shape energy of the surface with R and s refitted: every edge counts from both its ends.
// Source: thesis Eq 3.2, plus the elastic term.
template <class S>
S shape_energy(const Cells<S>& cells, Span<const Vec3<S>> surface, const detail::ElasticScale<S>& elastic) {
  S energy = S(0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellFit<S> fit = fit_cell(cells, surface, i, elastic);
    detail::for_each_edge(cells, i, [&](S w, const Vec3<S>& e, std::size_t j) {
      energy += w * ((surface[i] - surface[j]) - fit.s * (fit.R * e)).squaredNorm();
    });
    if (std::isfinite(elastic.mu)) energy += elastic.mu * cells.weighted_size[i] * (fit.s - S(1)) * (fit.s - S(1));
  }
  return energy;
}

}  // namespace rigless
