// A control point: what a user holds a surface by.
#pragma once

#include <cstdint>

namespace rigless {

// Where a control sits and how far its disc reaches along the surface; radius 0 holds the vertex alone.
template <class S>
struct Control {
  std::int32_t vertex = -1;
  S radius = S(0);
};

}  // namespace rigless
