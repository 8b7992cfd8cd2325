// What is built from frames, one after the other.
#pragma once

#include <doctest/doctest.h>

#include <vector>

#include "rigless/math/status.h"
#include "rigless/math/types.h"

namespace rigless::test {

// Adds all frames to a builder that has begun and works until it is done.
template <class S, class Builder>
Status build_from(Builder& builder, const std::vector<std::vector<Vec3<S>>>& frames) {
  for (const auto& frame : frames) {
    if (const Status s = builder.add_frame(frame); !s.ok()) return s;
  }
  double last = 0;
  while (builder.advance()) {
    CHECK(builder.progress() >= 0);
    CHECK(builder.progress() <= 1);
    last = builder.progress();
  }
  CHECK(last <= builder.progress());
  return {};
}

}  // namespace rigless::test
