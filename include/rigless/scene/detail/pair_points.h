// Which joint moves a point, and which vertex it is: as its user says, or as the shape has it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "rigless/mesh/shape_analysis.h"
#include "rigless/motion/joint_names.h"
#include "rigless/motion/joint_roles.h"
#include "rigless/retarget/detail/example.h"
#include "rigless/scene/body.h"
#include "rigless/scene/staged_motion.h"

namespace rigless::detail {

// For each name the joint that is called so, else the one that is the part of the body which the name means, in the
// spelling of any skeleton or in plain words ("left foot"); -1 where there is none. Allocates.
inline std::vector<std::int32_t> find_joints(const Skeleton& skeleton, const JointRoles& roles,
                                             const std::vector<std::string>& names) {
  std::vector<std::int32_t> joints;
  for (const JointName& said : read_joint_names(names)) {
    const auto same = std::find(skeleton.names.begin(), skeleton.names.end(), names[joints.size()]);
    const bool called_so = same != skeleton.names.end();
    joints.push_back(called_so ? static_cast<std::int32_t>(same - skeleton.names.begin())
                               : roles.find(said.side, said.part));
  }
  return joints;
}

// The joint that moves a point of the body, or -1: the whole pose. A foreleg is a hand on the ground, or
// goes with the foot across where there is no hand. No allocation.
template <class S>
std::int32_t joint_of_point(const JointRoles& roles, const BodyPoint<S>& point) {
  if (point.role == BodyRole::head) return roles.head;
  if (point.role == BodyRole::hips) return roles.root;
  if (point.role == BodyRole::chest) return roles.chest;
  if (point.side == 0) return -1;
  const LimbRoles& near = point.side > 0 ? roles.left : roles.right;
  const LimbRoles& across = point.side > 0 ? roles.right : roles.left;
  if (point.role == BodyRole::hand) return near.hand;
  if (point.role == BodyRole::foreleg) return near.hand >= 0 ? near.hand : across.ankle;
  if (point.role == BodyRole::elbow) return near.elbow;
  if (point.role == BodyRole::foot) return near.ankle;
  if (point.role == BodyRole::knee) return near.knee;
  return -1;
}

// The points that a body of this height needs, with radii in heights, and in `joints` what they follow. Point: as
// MeshPoint. Allocates. Errors: unknown_joint (the motion's joints cannot be told).
template <class S, class Point>
Status guess_points(const ShapeAnalysis<S>& shape, S height, const StagedMotion<double>& motion,
                    std::vector<Point>& points, std::vector<std::int32_t>& joints) {
  if (!motion.roles.known()) return {Error::unknown_joint, -1};
  for (const BodyPoint<S>& point : shape.points) {
    if (!point.wanted) continue;
    Point out;
    out.vertex = point.vertex;
    out.radius = point.radius / height;
    out.slab = point.role == BodyRole::hips || point.role == BodyRole::chest;
    points.push_back(out);
    joints.push_back(joint_of_point(motion.roles, point));
  }
  return {};
}

// Vertices for the points that have a position only, and in `joints` what all of them follow. Point: as MeshPoint.
// Allocates. Errors: index_out_of_range (a vertex, or more points than vertices), not_finite, unknown_joint (where:
// point); then both are half done.
template <class S, class Point>
Status find_points(Span<const Vec3<S>> vertices, const StagedMotion<double>& motion, std::vector<Point>& points,
                   std::vector<std::int32_t>& joints) {
  std::vector<std::string> names;
  for (const Point& point : points) names.push_back(point.joint);
  const std::vector<std::int32_t> found = find_joints(motion.clip.skeleton, motion.roles, names);
  std::vector<bool> taken(vertices.size(), false);
  for (std::size_t c = 0; c < points.size(); ++c) {
    Point& point = points[c];
    const auto where = static_cast<std::int32_t>(c);
    if (point.vertex < -1 || point.vertex >= count_of(vertices)) return {Error::index_out_of_range, where};
    if (!std::isfinite(point.radius)) return {Error::not_finite, where};
    if (point.vertex < 0) {
      if (!point.position.allFinite()) return {Error::not_finite, where};
      S least = std::numeric_limits<S>::max();
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        const S distance = (vertices[v] - point.position).squaredNorm();
        if (taken[v] || distance >= least) continue;
        least = distance;
        point.vertex = static_cast<std::int32_t>(v);
      }
      if (point.vertex < 0) return {Error::index_out_of_range, where};
    }
    nth(taken, point.vertex) = true;
    const std::int32_t joint = point.joint.empty() ? -1 : nth(found, c);
    if (joint < 0 && !point.joint.empty()) return {Error::unknown_joint, c};
    joints.push_back(joint);
  }
  return {};
}

// C: the limbs of a body's controls, as a performance takes them. Allocates.
template <class S>
std::vector<ModelLimb<double>> model_limbs(const Body<S>& body) {
  std::vector<ModelLimb<double>> limbs;
  for (const Limb<S>& limb : body.limbs())
    limbs.push_back({limb.base.template cast<double>(), static_cast<double>(limb.length), body.swing(limb)});
  return limbs;
}

}  // namespace rigless::detail
