// A rig for what never had one: few joints and smooth weights that move a mesh as its frames say.
#pragma once

#include <cmath>

#include "rigless/math/status.h"
#include "rigless/mesh/detail/one_ring.h"
#include "rigless/mesh/detail/weld.h"
#include "rigless/skin/detail/joint_growth.h"
#include "rigless/skin/detail/skin_likeness.h"

namespace rigless {

// Lengths are in diagonals of the box around the mesh at rest.
struct SkinOptions {
  std::int32_t joints = 64;  // at most, 1 to 255
  double rms = 0.0013;       // of all vertices in all frames: the fewest joints that reach this
  double worst = 0.008;      // and this
};

// V vertices, F frames, J joints. In frame f vertex v at p is at
//   root[f] (sum_k weight[4 v + k] (turn_j (p - centre_j) + place_j))   with j = joint[4 v + k] and its pose f J + j
template <class S>
struct Skin {
  static constexpr std::int32_t influences = detail::skin_influences;

  struct Pose {
    Eigen::Quaternion<S, Eigen::DontAlign> turn;  // the same sign from frame to frame
    Vec3<S> place;                                // where the joint's centre goes
  };

  std::vector<Vec3<S>> centre;      // J, at rest: in the middle of what it carries
  std::vector<std::int32_t> joint;  // V x 4; 0 where the weight is
  std::vector<S> weight;            // V x 4, they sum to one
  std::vector<Pose> root;           // F, about the origin: the whole body's rigid motion
  std::vector<Pose> pose;           // F x J
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
    if (rest.empty()) return {Error::empty_input, -1};
    if (!faces.empty()) {
      if (const Status s = detail::check_faces(faces, count_of(rest)); !s.ok()) return s;
    }
    for (std::size_t v = 0; v < rest.size(); ++v) {
      if (!std::isfinite(rest[v].squaredNorm())) return {Error::not_finite, v};
    }
    *this = SkinBuilder();
    options_ = options;
    rest_.assign(rest.begin(), rest.end());
    faces_.assign(faces.begin(), faces.end());
    first_ = detail::weld<S>(rest_);
    Vec3<S> low = rest[0], high = low;
    for (const Vec3<S>& p : rest_) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    diagonal_ = static_cast<double>((high - low).norm());
    return {};
  }

  // V positions. Allocates. Errors: size_mismatch; not_finite (vertex).
  Status add_frame(Span<const Vec3<S>> positions) {
    if (positions.size() != rest_.size()) return {Error::size_mismatch, -1};
    for (std::size_t v = 0; v < positions.size(); ++v) {
      if (!std::isfinite(positions[v].squaredNorm())) return {Error::not_finite, v};
    }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      if (positions[v] != nth(positions, first_[v])) first_[v] = static_cast<std::int32_t>(v);
    }
    roots_.push_back(detail::nearest_rigid_motion(
        count_of(rest_), [&](auto v) { return wide(nth(rest_, v)); }, [&](auto v) { return wide(positions[v]); }));
    frames_.insert(frames_.end(), positions.begin(), positions.end());
    return {};
  }

  // Works on; true while work is left. Without frames there is none. Allocates.
  bool advance() {
    if (roots_.empty()) return false;
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
        if (pose()) stage_ = finish() ? Stage::done : Stage::grow;
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
        return 0.8 + 0.2 * static_cast<double>(posed_) / static_cast<double>(roots_.size());
      case Stage::done:
        break;
    }
    return 1;
  }

  // What came out, after the last advance().
  const Skin<S>& skin() const { return skin_; }

 private:
  enum class Stage { gather, grow, weigh, pose, done };
  static constexpr std::int32_t sample = 3000;      // vertices that say how many joints there are and where
  static constexpr std::int32_t most_frames = 160;  // and frames
  static constexpr std::int32_t coordinates = 48;   // of a trajectory
  static constexpr int passes = 4;                  // of all vertices

  static Vec3<double> wide(const Vec3<S>& p) { return p.template cast<double>(); }

  // Where point i is in frame f before the root moves it.
  Vec3<double> now(std::size_t f, std::int32_t i) const {
    return roots_[f].back(wide(frames_[f * rest_.size() + to_size(nth(point_, i))]));
  }

  // 3F x many: how points leave their places at rest in the frames that are looked at.
  detail::SkinMatrix ways(Span<const std::int32_t> points) const {
    detail::SkinMatrix Y(3 * static_cast<Eigen::Index>(looked_.size()), static_cast<Eigen::Index>(points.size()));
    for (std::size_t k = 0; k < looked_.size(); ++k) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        Y.template block<3, 1>(static_cast<Eigen::Index>(3 * k), static_cast<Eigen::Index>(i)) =
            now(looked_[k], points[i]) - nth(at_rest_, points[i]);
      }
    }
    return Y;
  }

  void gather() {
    std::vector<std::int32_t> point_of(rest_.size());
    for (std::size_t v = 0; v < rest_.size(); ++v) {
      if (first_[v] == static_cast<std::int32_t>(v)) {
        point_of[v] = count_of(point_);
        point_.push_back(static_cast<std::int32_t>(v));
        at_rest_.push_back(wide(rest_[v]));
      }
      point_of[v] = nth(point_of, first_[v]);
    }
    first_ = std::move(point_of);
    std::vector<std::array<std::int32_t, 2>> pairs;
    for (Face& f : faces_) {
      for (std::int32_t& v : f) v = nth(first_, v);
      for (int k = 0; k < 3; ++k) {
        const std::int32_t a = f[to_size(k)], b = f[to_size((k + 1) % 3)];
        if (a != b) pairs.push_back({a, b});
      }
    }
    ring_ = detail::one_ring_from_pairs(pairs, count_of(point_));
    const auto every = [](std::size_t n, std::int32_t most) { return (n + to_size(most) - 1) / to_size(most); };
    step_ = every(roots_.size(), most_frames);
    for (std::size_t f = 0; f < roots_.size(); f += step_) looked_.push_back(f);
    std::vector<std::int32_t> chosen;
    for (std::size_t i = 0; i < point_.size(); i += every(point_.size(), sample)) {
      chosen.push_back(static_cast<std::int32_t>(i));
    }
    Y_ = ways(chosen);
    motion_.basis = detail::trajectory_basis(Y_, coordinates);
    std::vector<Vec3<double>> places;
    for (const std::int32_t i : chosen) places.push_back(nth(at_rest_, i));
    motion_.append(places, Y_);
    goal_ = {0.95 * options_.rms * diagonal_, 0.9 * options_.worst * diagonal_};
    growth_.begin(motion_, Y_);
    options_.joints = std::min(options_.joints, count_of(point_));
  }

  // A pass over all points; true after the last.
  bool weigh() {
    if (passes_ == 0) {
      whole_ = {};
      whole_.basis = motion_.basis;
      constexpr std::int32_t block = 1024;
      for (std::int32_t from = 0; from < count_of(point_); from += block) {
        std::vector<std::int32_t> some(to_size(std::min(block, count_of(point_) - from)));
        std::iota(some.begin(), some.end(), from);
        whole_.append({at_rest_.data() + from, some.size()}, ways(some));
      }
      fit_.joints = growth_.fit.joints;
      fit_.begin(whole_);
      fit_.fit_weights();
    } else {
      fit_.fit_joints();
      const double length = 0.5 * options_.rms * diagonal_;
      fit_.fit_weights({&ring_, length * length * static_cast<double>(looked_.size())});
    }
    if (++passes_ < passes) return false;
    poses_.begin(at_rest_, fit_.influences, count_of(fit_.joints));
    measure_ = detail::SkinMeasure(at_rest_, fit_.influences, faces_);
    posed_ = 0;
    skin_ = {};
    describe();
    return true;
  }

  void describe() {
    const std::int32_t J = count_of(fit_.joints);
    std::vector<Vec3<double>> sum(to_size(J), Vec3<double>::Zero());
    std::vector<double> all(to_size(J), 0);
    for (std::size_t i = 0; i < point_.size(); ++i) {
      const detail::Influences& of = fit_.influences[i];
      for (int a = 0; a < of.used(); ++a) {
        nth(sum, nth(of.joint, a)) += nth(of.weight, a) * at_rest_[i];
        nth(all, nth(of.joint, a)) += nth(of.weight, a);
      }
    }
    for (std::int32_t j = 0; j < J; ++j) {
      const Vec3<double> centre = nth(all, j) > 0 ? Vec3<double>(nth(sum, j) / nth(all, j)) : at_rest_[0];
      skin_.centre.push_back(centre.template cast<S>());
    }
    for (const std::int32_t i : first_) {
      const detail::Influences& of = nth(fit_.influences, i);
      for (int a = 0; a < Skin<S>::influences; ++a) {
        skin_.joint.push_back(std::max(0, nth(of.joint, a)));
        skin_.weight.push_back(static_cast<S>(nth(of.weight, a)));
      }
    }
  }

  // The next frame; true after the last.
  bool pose() {
    std::vector<Vec3<double>> present(point_.size());
    for (std::int32_t i = 0; i < count_of(point_); ++i) nth(present, i) = now(posed_, i);
    for (std::size_t j = 0; j < poses_.pose.size(); ++j) {  // from the frame beside it that the fit has looked at
      poses_.pose[j] = fit_.joints[j].middleRows<3>(static_cast<Eigen::Index>(3 * (posed_ / step_)));
    }
    poses_.fit([&](std::size_t i) -> const Vec3<double>& { return present[i]; });
    measure_.add(poses_, present);
    add_pose(skin_.root, 1, roots_[posed_].R, roots_[posed_].t);
    for (std::size_t j = 0; j < poses_.pose.size(); ++j) {
      const detail::JointMotion& D = poses_.pose[j];
      const Vec3<double> centre = wide(skin_.centre[j]);
      const Vec3<double> place = centre + D * detail::lifted(centre);
      add_pose(skin_.pose, poses_.pose.size(), D.template leftCols<3>() + Mat3<double>::Identity(), place);
    }
    return ++posed_ == roots_.size();
  }

  static void add_pose(std::vector<typename Skin<S>::Pose>& to, std::size_t step, const Mat3<double>& R,
                       const Vec3<double>& place) {
    Eigen::Quaternion<double> q(R);
    q.normalize();
    Eigen::Quaternion<S, Eigen::DontAlign> turn(q.template cast<S>());
    if (to.size() >= step && to[to.size() - step].turn.dot(turn) < 0) turn.coeffs() = -turn.coeffs();
    to.push_back({turn, place.template cast<S>()});
  }

  // False when more joints are worth a try: what the sample said was not true of all.
  bool finish() {
    skin_.rms = diagonal_ > 0 ? measure_.rms() / diagonal_ : 0;
    skin_.worst = diagonal_ > 0 ? measure_.worst() / diagonal_ : 0;
    skin_.normals = measure_.normals_rms();
    const bool reached = skin_.rms <= options_.rms && skin_.worst <= options_.worst;
    if (reached || skin_.joints() >= options_.joints || ++rounds_ > 3) return true;
    goal_.rms *= std::min(0.97, options_.rms / skin_.rms);
    goal_.worst *= std::min(0.97, options_.worst / skin_.worst);
    passes_ = 0;
    return false;
  }

  SkinOptions options_;
  double diagonal_ = 0;
  std::vector<Vec3<S>> rest_, frames_;
  std::vector<Face> faces_;
  std::vector<std::int32_t> first_;  // of each vertex: the one that it goes with, then its point
  std::vector<detail::RigidMotion> roots_;

  Stage stage_ = Stage::gather;
  std::vector<std::int32_t> point_;    // a vertex of each point
  std::vector<Vec3<double>> at_rest_;  // of points
  std::vector<std::size_t> looked_;    // frames that the fit looks at: every step_
  std::size_t step_ = 1;
  OneRing ring_;
  detail::SkinMatrix Y_;
  detail::Trajectories motion_, whole_;
  detail::SkinError goal_;
  detail::JointGrowth growth_;
  detail::JointFit fit_;
  detail::FramePoses poses_;
  detail::SkinMeasure measure_;
  int passes_ = 0, rounds_ = 0;
  std::size_t posed_ = 0;
  Skin<S> skin_;
};

}  // namespace rigless
