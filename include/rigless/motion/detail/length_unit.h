// Lengths and axes of motion files. Public through standardise().
#pragma once

#include <cstdint>

namespace rigless {

inline constexpr double person_height = 1.7;  // metres, where nothing better is known

enum class LengthUnit : std::int32_t { metre, centimetre, millimetre, inch, cmu, foot, none };

template <class S>
struct UnitGuess {
  S metres_per_unit = 1;
  LengthUnit unit = LengthUnit::none;  // none: the body is as tall as no unit makes it, and scaled to person_height
};

enum class UpAxis : std::int32_t { y, z, minus_y, minus_z };

}  // namespace rigless
