// What the spacetime system is told: options, and what each control is learned from.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rigless/math/span.h"
#include "rigless/math/status.h"
#include "rigless/math/types.h"
#include "rigless/retarget/detail/spacetime_track.h"
#include "rigless/retarget/detail/weight_elimination.h"

namespace rigless::detail {

template <class S>
struct SpacetimeOptions {
  WeightOptions<S> weights;
  // An offset track exists only on tracks with a constraint, so that a constraint changes no other track.
  TrackOptions<S> track;
  // Give of the hard constraints: repeated or contradicting ones meet at the nearest compromise.
  S compliance = S(1e-9);
  bool keep_weights = true;  // else weights() is empty

  // The paper's own formulation: the 4 nearest examples, a soft affine row, exact constraints.
  static SpacetimeOptions thesis() {
    SpacetimeOptions options;
    options.weights.locality = options.weights.sharing = 0;
    options.weights.soft_affine = 1;
    options.weights.nearest = 4;
    options.compliance = 0;
    return options;
  }
};

// What one control is learned from.
template <class S>
struct TrackInput {
  Span<const S> features;                // T x D, or the first of the D where `shared` has the others
  Span<const S> example_features;        // N x D
  Span<const Vec3<S>> example_controls;  // N
  Span<const S> stiffness = {};          // T x N further costs of the weights, see WeightCost; usually empty
  Span<const S> pull = {};
  Span<const S> shared = {};  // T x E: features that other tracks have too
  S share = 1;                // times which they count

  // D; what is left over shows in check_track().
  std::size_t dimension(std::size_t frames) const { return (features.size() + shared.size()) / frames; }
};

// What is wrong with a track of that many frames: no_examples, size_mismatch or not_finite.
template <class S>
Error check_track(const TrackInput<S>& in, std::size_t frames) {
  const std::size_t examples = in.example_controls.size();
  if (examples == 0) return Error::no_examples;
  const std::size_t dimension = in.dimension(frames);
  if (dimension == 0 || in.features.size() % frames != 0 || in.shared.size() % frames != 0 ||
      in.example_features.size() != examples * dimension || in.stiffness.size() != in.pull.size() ||
      (!in.pull.empty() && in.pull.size() != frames * examples))
    return Error::size_mismatch;
  const auto finite = [](S x) { return std::isfinite(x); };
  if (!std::all_of(in.features.begin(), in.features.end(), finite)) return Error::not_finite;
  if (!std::all_of(in.shared.begin(), in.shared.end(), finite)) return Error::not_finite;
  if (!std::all_of(in.example_features.begin(), in.example_features.end(), finite)) return Error::not_finite;
  for (const Vec3<S>& c : in.example_controls)
    if (!c.allFinite()) return Error::not_finite;
  return Error::none;
}

}  // namespace rigless::detail
