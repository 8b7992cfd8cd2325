// The bones of an Acclaim skeleton, as its file tells them. Public through parse_asf().
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "rigless/math/types.h"
#include "rigless/motion/detail/text_scanner.h"

namespace rigless {

// One value of a bone's line in an AMC file.
struct AcclaimChannel {
  enum class Kind : std::int32_t { rotation, translation, length };
  Kind kind;
  std::int32_t axis;
};

struct AcclaimBone {
  std::string name;
  std::int32_t parent = -1;                       // an earlier bone; -1: the root, or a bone that hangs nowhere
  Vec3<double> direction = Vec3<double>::Zero();  // at rest, in world axes, unit
  double length = 0;                              // file units
  Mat3<double> axis = Mat3<double>::Identity();   // C: the bone's own axes in the world at rest
  std::vector<AcclaimChannel> channels;           // in the order of the values, the first turn being applied first
};

struct AcclaimSkeleton {
  std::vector<AcclaimBone> bones;                       // 0 is the root
  std::vector<std::int32_t> order;                      // bones of the hierarchy, a parent before its children
  std::unordered_map<std::string, std::int32_t> index;  // by name
  Vec3<double> root_position = Vec3<double>::Zero();
  double length_unit = 1;  // a value times 0.0254 / length_unit is metres
  bool degrees = true;

  // A bone by its name, or by its name in other case; -1 if there is none.
  std::int32_t find(std::string_view name) const {
    const auto found = index.find(std::string(name));
    if (found != index.end()) return found->second;
    for (std::size_t b = 0; b < bones.size(); ++b) {
      if (detail::same_word(bones[b].name, name)) return static_cast<std::int32_t>(b);
    }
    return -1;
  }
};

}  // namespace rigless
