// A rig for what never had one: few joints and smooth weights that move a mesh as its frames say.
#pragma once

#include <cmath>

#include "rigless/skin/detail/joint_growth.h"
#include "rigless/skin/detail/moving_points.h"
#include "rigless/skin/detail/rigid_pose.h"
#include "rigless/skin/detail/skin_correctives.h"
#include "rigless/skin/detail/skin_likeness.h"

namespace rigless {

// Lengths are in diagonals of the box around the mesh at rest.
struct SkinOptions {
  std::int32_t joints = 64;  // at most, 1 to 255
  double rms = 0.0013;       // of all vertices in all frames: the fewest joints that reach this
  double worst = 0.008;      // and this
  std::int32_t targets = 8;  // at most, where joints alone do not
};

// V vertices, F frames, J joints, K morph targets. In frame f vertex v at rest_v is at
//   root[f] (sum_k weight[4 v + k] (turn_j (p - centre_j) + place_j))   with j = joint[4 v + k] and its pose f J + j
// and p = rest_v + sum_k mix[f K + k] way[k V + v].
template <class S>
struct Skin {
  static constexpr std::int32_t influences = detail::skin_influences;

  // How a joint is turned, with the same sign from frame to frame, and where its centre goes.
  using Pose = detail::RigidPose<S>;

  std::vector<Vec3<S>> centre;      // J, at rest: in the middle of what it carries
  std::vector<std::int32_t> joint;  // V x 4; 0 where the weight is
  std::vector<S> weight;            // V x 4, they sum to one
  std::vector<Pose> root;           // F, about the origin: the whole body's rigid motion
  std::vector<Pose> pose;           // F x J
  std::vector<Vec3<S>> way;         // K x V
  std::vector<S> mix;               // F x K; of each target the largest is 1 or -1
  std::int32_t targets = 0;         // K
  double rms = 0, worst = 0;        // as in SkinOptions
  double normals = 0;               // radians, rms

  std::int32_t joints() const { return count_of(centre); }
};

// begin(), add_frame() for each frame of all motions, then advance() until it returns false.
template <class S>
class SkinBuilder {
 public:
  // Copies what it needs. Vertices at one place at rest that stay together in all frames get the same weights, as at a
  // seam. Allocates. Errors: empty_input; index_out_of_range (face); not_finite (vertex).
  Status begin(Span<const Vec3<S>> rest, Span<const Face> faces, const SkinOptions& options = {}) {
    RIGLESS_ASSERT(options.joints > 0 && options.joints < 256);
    detail::MovingPoints<S> points;
    if (const Status s = points.begin(rest, faces); !s.ok()) return s;
    *this = SkinBuilder();
    options_ = options;
    points_ = std::move(points);
    return {};
  }

  // V positions. Allocates. Errors: size_mismatch; not_finite (vertex).
  Status add_frame(Span<const Vec3<S>> positions) { return points_.add_frame(positions); }

  // Works on; true while work is left. Without frames there is none. Allocates.
  bool advance() {
    if (points_.roots.empty()) return false;
    switch (stage_) {
      case Stage::gather:
        gather();
        stage_ = growth_.enough(goal_, options_.joints) ? Stage::weigh : Stage::grow;
        break;
      case Stage::grow:
        if (growth_.grow(goal_, options_.joints)) stage_ = Stage::weigh;
        break;
      case Stage::weigh:
        if (weigh()) stage_ = Stage::pose;
        break;
      case Stage::pose:
        if (pose()) stage_ = finish() ? Stage::correct : Stage::grow;
        break;
      case Stage::correct:
        if (!correctives_.advance(points_, fit_.influences, options_, skin_)) stage_ = Stage::done;
        break;
      case Stage::done:
        break;
    }
    return stage_ != Stage::done;
  }

  // 0 to 1, about.
  double progress() const {
    const double joints = count_of(growth_.fit.joints);
    switch (stage_) {
      case Stage::gather:
        return 0;
      case Stage::grow:
        return 0.1 + 0.5 * std::min(1.0, joints / 24 / (1 + joints / options_.joints));
      case Stage::weigh:
        return 0.6 + 0.06 * passes_;
      case Stage::pose:
        return 0.8 + 0.1 * static_cast<double>(posed_) / static_cast<double>(points_.roots.size());
      case Stage::correct:
        return 0.9 + 0.1 * correctives_.progress();
      case Stage::done:
        break;
    }
    return 1;
  }

  // What came out, after the last advance().
  const Skin<S>& skin() const { return skin_; }

 private:
  enum class Stage { gather, grow, weigh, pose, correct, done };
  static constexpr std::int32_t sample = 3000;      // vertices that say how many joints there are and where
  static constexpr std::int32_t most_frames = 160;  // and frames
  static constexpr std::int32_t coordinates = 48;   // of a trajectory
  static constexpr int passes = 4;                  // of all vertices

  void gather() {
    points_.gather(most_frames);
    const std::int32_t every = (points_.count() + sample - 1) / sample;
    std::vector<std::int32_t> chosen;
    std::vector<Vec3<double>> places;
    for (std::int32_t i = 0; i < points_.count(); i += every) {
      chosen.push_back(i);
      places.push_back(nth(points_.rest, i));
    }
    Y_ = points_.ways(chosen);
    motion_.basis = detail::trajectory_basis(Y_, coordinates);
    motion_.append(places, Y_);
    goal_ = {0.95 * options_.rms * points_.diagonal, 0.9 * options_.worst * points_.diagonal};
    growth_.begin(motion_, Y_);
    options_.joints = std::min(options_.joints, points_.count());
  }

  // A pass over all points; true after the last.
  bool weigh() {
    if (passes_ == 0) {
      whole_ = {};
      whole_.basis = motion_.basis;
      constexpr std::int32_t block = 1024;
      for (std::int32_t from = 0; from < points_.count(); from += block) {
        std::vector<std::int32_t> some(to_size(std::min(block, points_.count() - from)));
        std::iota(some.begin(), some.end(), from);
        whole_.append({points_.rest.data() + from, some.size()}, points_.ways(some));
      }
      fit_.joints = growth_.fit.joints;
      fit_.begin(whole_);
      fit_.fit_weights();
    } else {
      fit_.fit_joints();
      const double length = 0.5 * options_.rms * points_.diagonal;
      fit_.fit_weights({&points_.ring, length * length * static_cast<double>(points_.looked.size())});
    }
    if (++passes_ < passes) return false;
    poses_.begin(points_.rest, fit_.influences, count_of(fit_.joints));
    measure_ = detail::SkinMeasure(points_.rest, fit_.influences, points_.faces);
    posed_ = 0;
    skin_ = {};
    describe();
    return true;
  }

  void describe() {
    const std::int32_t J = count_of(fit_.joints);
    std::vector<Vec3<double>> sum(to_size(J), Vec3<double>::Zero());
    std::vector<double> all(to_size(J), 0);
    for (std::size_t i = 0; i < points_.rest.size(); ++i) {
      const detail::Influences& of = fit_.influences[i];
      for (int a = 0; a < of.used(); ++a) {
        nth(sum, nth(of.joint, a)) += nth(of.weight, a) * points_.rest[i];
        nth(all, nth(of.joint, a)) += nth(of.weight, a);
      }
    }
    for (std::int32_t j = 0; j < J; ++j) {
      const Vec3<double> centre = nth(all, j) > 0 ? Vec3<double>(nth(sum, j) / nth(all, j)) : points_.rest[0];
      skin_.centre.push_back(centre.template cast<S>());
    }
    for (const std::int32_t i : points_.of_vertex) {
      const detail::Influences& of = nth(fit_.influences, i);
      for (int a = 0; a < Skin<S>::influences; ++a) {
        skin_.joint.push_back(std::max(0, nth(of.joint, a)));
        skin_.weight.push_back(static_cast<S>(nth(of.weight, a)));
      }
    }
  }

  // The next frame; true after the last.
  bool pose() {
    std::vector<Vec3<double>> present(points_.rest.size());
    for (std::int32_t i = 0; i < points_.count(); ++i) nth(present, i) = points_.now(posed_, i);
    for (std::size_t j = 0; j < poses_.pose.size(); ++j) {  // from the frame beside it that the fit has looked at
      poses_.pose[j] = fit_.joints[j].middleRows<3>(static_cast<Eigen::Index>(3 * (posed_ / points_.step)));
    }
    poses_.fit([&](std::size_t i) -> const Vec3<double>& { return present[i]; });
    measure_.add(poses_, present);
    detail::add_pose(skin_.root, 1, points_.roots[posed_].R, points_.roots[posed_].t);
    for (std::size_t j = 0; j < poses_.pose.size(); ++j) {
      const detail::JointMotion& D = poses_.pose[j];
      const Vec3<double> centre = skin_.centre[j].template cast<double>();
      const Vec3<double> place = centre + D * detail::lifted(centre);
      detail::add_pose(skin_.pose, poses_.pose.size(), D.template leftCols<3>() + Mat3<double>::Identity(), place);
    }
    return ++posed_ == points_.roots.size();
  }

  // False when more joints are worth a try: what the sample said was not true of all.
  bool finish() {
    skin_.rms = points_.diagonal > 0 ? measure_.rms() / points_.diagonal : 0;
    skin_.worst = points_.diagonal > 0 ? measure_.worst() / points_.diagonal : 0;
    skin_.normals = measure_.normals_rms();
    const bool reached = skin_.rms <= options_.rms && skin_.worst <= options_.worst;
    if (reached || skin_.joints() >= options_.joints || ++rounds_ > 3) return true;
    goal_.rms *= std::min(0.97, options_.rms / skin_.rms);
    goal_.worst *= std::min(0.97, options_.worst / skin_.worst);
    passes_ = 0;
    return false;
  }

  SkinOptions options_;
  detail::MovingPoints<S> points_;
  Stage stage_ = Stage::gather;
  detail::SkinMatrix Y_;
  detail::Trajectories motion_, whole_;
  detail::SkinError goal_;
  detail::JointGrowth growth_;
  detail::JointFit fit_;
  detail::FramePoses poses_;
  detail::SkinMeasure measure_;
  detail::SkinCorrectives<S> correctives_;
  int passes_ = 0, rounds_ = 0;
  std::size_t posed_ = 0;
  Skin<S> skin_;
};

}  // namespace rigless
