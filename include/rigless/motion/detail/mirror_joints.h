// Which joint is which in the mirror.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/motion/detail/name_reader.h"
#include "rigless/motion/joint_roles.h"

namespace rigless::detail {

// J: the joint on the other side of the body, itself on the middle line and where there is none. By the roles, and for
// joints without one (fingers, helpers, ends) in their order by what their names say. Mirroring twice gives the joint
// again. Allocates.
inline std::vector<std::int32_t> mirror_joints(const Skeleton& skeleton, const JointRoles& roles) {
  const auto count = static_cast<std::int32_t>(skeleton.names.size());
  std::vector<std::int32_t> mirror;
  for (std::int32_t j = 0; j < count; ++j) mirror.push_back(j);
  const auto twin = [&](std::int32_t j) -> std::int32_t& { return mirror[static_cast<std::size_t>(j)]; };
  const auto pair = [&](std::int32_t a, std::int32_t b) {
    if (a < 0 || b < 0 || a == b || twin(a) != a || twin(b) != b) return;
    twin(a) = b;
    twin(b) = a;
  };
  for (std::int32_t part = 1; part < static_cast<std::int32_t>(BodyPart::end); ++part) {
    const auto one = static_cast<BodyPart>(part);
    pair(roles.find(BodySide::left, one), roles.find(BodySide::right, one));
  }
  const NameReader reader(skeleton.names);
  const std::vector<JointName> names = reader.read();
  const auto same = [&](std::int32_t a, std::int32_t b) {
    const auto l = static_cast<std::size_t>(a), r = static_cast<std::size_t>(b);
    if (names[l].part != names[r].part || names[r].side != BodySide::right) return false;
    const bool many =
        names[l].part == BodyPart::none || names[l].part == BodyPart::finger || names[l].part == BodyPart::end;
    return !many || reader.names()[l].words == reader.names()[r].words;
  };
  for (std::int32_t a = 0; a < count; ++a) {
    for (std::int32_t b = 0; b < count && names[static_cast<std::size_t>(a)].side == BodySide::left && twin(a) == a;
         ++b) {
      if (twin(b) == b && same(a, b)) pair(a, b);
    }
  }
  return mirror;
}

}  // namespace rigless::detail
