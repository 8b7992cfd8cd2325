// A human of ten joints who walks on the spot, and a model of four controls that learns from him.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "rigless/motion/joint_roles.h"

namespace rigless::test::walker {

enum : std::int32_t {
  root,
  neck,
  head,
  left_hip,
  left_foot,
  right_hip,
  right_foot,
  shoulder,
  elbow,
  hand,
  joint_count
};

inline const Skeleton skeleton = {
    {"root", "neck", "head", "lhip", "lfoot", "rhip", "rfoot", "shoulder", "elbow", "hand"},
    {-1, root, neck, root, left_hip, root, right_hip, neck, shoulder, elbow}};

inline JointRoles roles() {
  JointRoles roles;
  roles.neck = neck;
  roles.head = head;
  roles.left.hip = left_hip;
  roles.left.ankle = left_foot;
  roles.right.hip = right_hip;
  roles.right.ankle = right_foot;
  roles.left.shoulder = shoulder;
  roles.left.elbow = elbow;
  roles.left.hand = hand;
  return roles;
}

// Upright, the arm hanging; hips 0.9 m above the soles.
inline std::vector<Vec3<double>> standing() {
  return {{0, 0, 0},    {0, 0.5, 0},     {0, 0.8, 0},    {0.1, 0, 0},    {0.1, -0.9, 0},
          {-0.1, 0, 0}, {-0.1, -0.9, 0}, {0.2, 0.45, 0}, {0.2, 0.15, 0}, {0.2, -0.15, 0}};
}

inline std::vector<Vec3<double>> walking(std::int32_t frames) {
  std::vector<Vec3<double>> clip;
  for (std::int32_t f = 0; f < frames; ++f) {
    const double phase = 0.2 * f, swing = 0.3 * std::sin(phase);
    std::vector<Vec3<double>> pose = standing();
    pose[head].z() = 0.02 * std::sin(2 * phase);
    pose[left_foot] += Vec3<double>(0, 0.05 * std::max(0.0, std::cos(phase)), swing);
    pose[right_foot] += Vec3<double>(0, 0.05 * std::max(0.0, -std::cos(phase)), -swing);
    clip.insert(clip.end(), pose.begin(), pose.end());
  }
  return clip;
}

// Where the model's head, feet and belly rest.
inline const std::vector<Vec3<double>> rest = {{0, 1.7, 0.4}, {0.3, 0, 0}, {-0.3, 0, 0}, {0, 0.8, -0.6}};

}  // namespace rigless::test::walker
