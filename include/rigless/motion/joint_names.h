// What joint names say: the side, the part of the body, and words for people.
#pragma once

#include <string>
#include <vector>

#include "rigless/motion/detail/body_parts.h"
#include "rigless/motion/detail/joint_labels.h"
#include "rigless/motion/detail/name_reader.h"

namespace rigless {

// J: the names of one skeleton together, because they explain each other: what most of them share at either end says
// nothing, "leg" is the knee beside an "upleg" but the thigh beside a "shin", and "lfemur" is the knee in an Acclaim
// file, whose joints are the ENDS of their bones. UTF-8. Several joints may be the same part of a side (a spine, two
// bones of one thigh); which of them carries the part the tree says: see joint_roles.h. Allocates.
// Source: tests/golden/joint-names.json.
inline std::vector<JointName> read_joint_names(const std::vector<std::string>& names);

// ---------------------------------------------------------------------------------------------------------------------

inline std::vector<JointName> read_joint_names(const std::vector<std::string>& names) {
  const detail::NameReader reader(names);
  std::vector<JointName> result = reader.read();
  detail::label_joints(reader.names(), result);
  return result;
}

}  // namespace rigless
