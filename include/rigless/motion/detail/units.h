// Metres per unit of a file that does not say its unit, guessed from the size of the body in it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/motion/clip.h"
#include "rigless/motion/detail/length_unit.h"
#include "rigless/motion/joint_roles.h"

namespace rigless::detail {

// Height of the upright body in the clip's units: the bones from ankle over hip and root to the top of the head,
// measured in the first frame, or without these roles how high the joints reach above each other, median over the
// frames. Allocates scratch.
template <class S>
S standing_height(const Clip<S>& clip, const JointRoles& roles);

// The unit that brings the height nearest to person_height on a logarithmic scale, if that is between 1.0 m and 2.4 m
// (a child, a giant); otherwise the factor that makes it that. 1 for a clip without extent. `cmu` is 0.45 inch, the
// unit of CMU's files and of the BVH files made from them, who are no giants: a child in inches, of 0.9 m at least, is
// as tall in numbers. Allocates scratch.
template <class S>
UnitGuess<S> guess_unit(const Clip<S>& clip, const JointRoles& roles);

// Multiplies all positions and metres_per_unit. `factor` > 0. Does not allocate.
template <class S>
void scale_clip(Clip<S>& clip, S factor);

// ---------------------------------------------------------------------------------------------------------------------

// Length of the bones from `joint` up to `ancestor`; 0 if that is not above it.
template <class S>
S chain_length(const Clip<S>& clip, std::int32_t joint, std::int32_t ancestor) {
  S length = 0;
  while (joint >= 0 && joint != ancestor) {
    const std::int32_t parent = clip.skeleton.parents[static_cast<std::size_t>(joint)];
    if (parent >= 0) length += (clip.at(0, joint) - clip.at(0, parent)).norm();
    joint = parent;
  }
  return joint == ancestor ? length : S(0);
}

template <class S>
S median_extent(const Clip<S>& clip) {
  std::vector<S> extents;
  for (std::int32_t f = 0; f < clip.frames; ++f) {
    S low = clip.at(f, 0).y();
    S high = low;
    for (std::int32_t j = 1; j < clip.joints(); ++j) {
      low = std::min(low, clip.at(f, j).y());
      high = std::max(high, clip.at(f, j).y());
    }
    extents.push_back(high - low);
  }
  const auto middle = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 2);
  std::nth_element(extents.begin(), middle, extents.end());
  return *middle;
}

template <class S>
S standing_height(const Clip<S>& clip, const JointRoles& roles) {
  if (clip.frames == 0) return 0;
  const S leg =
      std::max(chain_length(clip, roles.left.ankle, roles.root), chain_length(clip, roles.right.ankle, roles.root));
  S trunk = chain_length(clip, roles.head, roles.root);
  for (std::int32_t j = 0; j < clip.joints() && roles.head >= 0; ++j) {  // an end above the head
    if (clip.skeleton.parents[static_cast<std::size_t>(j)] != roles.head) continue;
    trunk = std::max(trunk, chain_length(clip, j, roles.root));
  }
  return leg > 0 && trunk > 0 ? leg + trunk : median_extent(clip);
}

template <class S>
UnitGuess<S> guess_unit(const Clip<S>& clip, const JointRoles& roles) {
  constexpr std::array<double, 6> metres = {1.0, 0.01, 0.001, 0.0254, 0.0254 / 0.45, 0.3048};  // as LengthUnit
  const double height = static_cast<double>(standing_height(clip, roles));
  if (!(height > 1e-9) || !std::isfinite(height)) return {};
  std::size_t best = 0;
  const auto distance = [&](std::size_t k) { return std::abs(std::log(height * metres[k] / person_height)); };
  for (std::size_t k = 1; k < metres.size(); ++k) {
    const bool giant = static_cast<LengthUnit>(k) == LengthUnit::cmu && height * metres[k] > 2.06;
    if (!giant && distance(k) < distance(best)) best = k;
  }
  const double tall = height * metres[best];
  const double least = static_cast<LengthUnit>(best) == LengthUnit::inch ? 0.9 : 1.0;
  if (tall < least || tall > 2.4) return {static_cast<S>(person_height / height), LengthUnit::none};
  return {static_cast<S>(metres[best]), static_cast<LengthUnit>(best)};
}

template <class S>
void scale_clip(Clip<S>& clip, S factor) {
  RIGLESS_ASSERT(factor > 0);
  for (Vec3<S>& p : clip.positions) p *= factor;
  clip.metres_per_unit *= factor;
}

}  // namespace rigless::detail
