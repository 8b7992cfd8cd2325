// An Acclaim skeleton in the poses that its values tell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/motion/clip.h"
#include "rigless/motion/detail/acclaim_skeleton.h"
#include "rigless/motion/detail/amc_parser.h"
#include "rigless/motion/detail/euler.h"

namespace rigless::detail {

// One frame of world positions and rotations, in file units. Bone by bone C M inverse(C) turns it from rest in its
// parent's axes; M applies the channels first to last.
inline void pose_acclaim(const AcclaimSkeleton& skeleton, const AmcParser& motion, const double* values,
                         std::vector<Vec3<double>>& positions, std::vector<Mat3<double>>& rotations) {
  const double angle_unit = motion.degrees() ? radians_per_degree : 1.0;
  for (const std::int32_t index : skeleton.order) {
    const std::size_t b = static_cast<std::size_t>(index);
    const AcclaimBone& bone = skeleton.bones[b];
    Vec3<double> translation = bone.parent < 0 ? skeleton.root_position : Vec3<double>(bone.direction * bone.length);
    Mat3<double> turn = Mat3<double>::Identity();
    const double* value = values + motion.first(b);
    for (std::size_t k = bone.channels.size(); k-- > 0;) {
      const AcclaimChannel& channel = bone.channels[k];
      if (channel.kind == AcclaimChannel::Kind::rotation) turn_about_axis(channel.axis, value[k] * angle_unit, turn);
      if (channel.kind == AcclaimChannel::Kind::translation && bone.parent < 0) translation[channel.axis] = value[k];
    }
    rotations[b] = turned_by(turned_by(bone.axis, turn), bone.axis.transpose());
    positions[b] = translation;
    if (bone.parent < 0) continue;
    const std::size_t parent = static_cast<std::size_t>(bone.parent);
    rotations[b] = turned_by(rotations[parent], rotations[b]);
    positions[b] = positions[parent] + rotations[b] * translation;
  }
}

template <class S>
void add_acclaim_skeleton(const AcclaimSkeleton& skeleton, Clip<S>& clip, ParseNotes& notes) {
  std::vector<std::int32_t> joint_of_bone(skeleton.bones.size(), -1);
  for (const std::int32_t index : skeleton.order) {
    const AcclaimBone& bone = skeleton.bones[static_cast<std::size_t>(index)];
    joint_of_bone[static_cast<std::size_t>(index)] = clip.joints();
    const std::int32_t parent = bone.parent < 0 ? -1 : joint_of_bone[static_cast<std::size_t>(bone.parent)];
    clip.skeleton.names.push_back(bone.name);
    clip.skeleton.parents.push_back(parent);
    notes.rest.push_back(
        parent < 0 ? Vec3<double>(0, 0, 0)
                   : Vec3<double>(notes.rest[static_cast<std::size_t>(parent)] + bone.direction * bone.length));
    for (const AcclaimChannel& channel : bone.channels) {
      const bool used = channel.kind == AcclaimChannel::Kind::rotation ||
                        (channel.kind == AcclaimChannel::Kind::translation && parent < 0);
      notes.lengths_ignored += used ? 0 : 1;
    }
  }
}

}  // namespace rigless::detail
