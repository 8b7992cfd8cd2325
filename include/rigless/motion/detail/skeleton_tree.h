// Who is above whom in a skeleton.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "rigless/motion/clip.h"

namespace rigless::detail {

// Joints are -1 where there is none, and every question about -1 is answered with -1 or no.
class SkeletonTree {
 public:
  explicit SkeletonTree(const Skeleton& skeleton) : parents_(skeleton.parents), children_(skeleton.parents.size()) {
    sizes_.assign(parents_.size(), 1);
    for (std::int32_t j = joints(); j-- > 0;) {
      if (parent(j) < 0) continue;
      sizes_[index(parent(j))] += sizes_[index(j)];
      children_[index(parent(j))].insert(children_[index(parent(j))].begin(), j);
    }
  }

  std::int32_t joints() const { return static_cast<std::int32_t>(parents_.size()); }
  std::int32_t parent(std::int32_t joint) const { return joint < 0 ? -1 : parents_[index(joint)]; }
  const std::vector<std::int32_t>& children(std::int32_t joint) const { return children_[index(joint)]; }
  std::int32_t size(std::int32_t joint) const { return sizes_[index(joint)]; }  // of the branch, with the joint
  std::int32_t first_child(std::int32_t joint) const {
    return joint < 0 || children(joint).empty() ? -1 : children(joint)[0];
  }

  // Whether `joint` is `ancestor` or hangs on it.
  bool within(std::int32_t joint, std::int32_t ancestor) const {
    while (joint >= 0 && joint != ancestor) joint = parent(joint);
    return joint >= 0;
  }
  bool below(std::int32_t joint, std::int32_t ancestor) const { return within(parent(joint), ancestor); }

  // The lowest joint above both (or one of them); that which is not -1 if one is.
  std::int32_t meeting(std::int32_t a, std::int32_t b) const {
    if (a < 0 || b < 0) return std::max(a, b);
    while (!within(b, a)) a = parent(a);
    return a;
  }

  // From the root to `joint`, both included.
  std::vector<std::int32_t> path_to(std::int32_t joint) const {
    std::vector<std::int32_t> path;
    for (; joint >= 0; joint = parent(joint)) path.push_back(joint);
    std::reverse(path.begin(), path.end());
    return path;
  }

 private:
  static std::size_t index(std::int32_t joint) { return static_cast<std::size_t>(joint); }

  std::vector<std::int32_t> parents_;
  std::vector<std::vector<std::int32_t>> children_;
  std::vector<std::int32_t> sizes_;
};

}  // namespace rigless::detail
