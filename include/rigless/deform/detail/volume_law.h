// How much a stretched cell is squeezed across, in the pose state: where the shape state stretched it along one axis,
// its volume is kept by the two others. Public through Deformer::pose().
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigless {

// s' = s^lambda_v: equal to the thesis' Eq 3.12 to first order, and positive for every squash, where the linear law
// turns negative below s = 1 - 1 / lambda_v.
template <class S>
struct PowerLaw {
  S lambda_v = S(1);
  S lowest = S(0.25);
  S highest = S(4);

  S operator()(S s) const {
    const S safe = std::max(s, std::numeric_limits<S>::min());
    return std::min(std::max(lambda_v == S(1) ? safe : std::pow(safe, lambda_v), lowest), highest);
  }
};

}  // namespace rigless
