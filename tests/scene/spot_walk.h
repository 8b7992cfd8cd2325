// A cow that walks like a man: the mesh and the motion with which the whole way is tested. Both lie beside the project
// and may be absent.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/standardise.h"
#include "rigless/scene/body.h"
#include "rigless/scene/performance_builder.h"

namespace rigless {

inline std::string read_shared(const std::string& path) {
  std::ifstream file(std::string(RIGLESS_SHARED_DIR) + "data/" + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

template <class S>
struct SpotWalk {
  std::vector<Vec3<S>> rest;
  std::vector<Face> faces;
  S height = 0;
  Body<S> body;
  std::vector<Control<S>> controls;
  std::vector<std::int32_t> pairs;
  StagedMotion<double> motion;

  bool load() {
    const std::string obj = read_shared("meshes/spot.obj"), asf = read_shared("motions/02.asf"),
                      amc = read_shared("motions/02_01.amc");
    if (obj.empty() || asf.empty() || amc.empty()) return false;
    read_mesh(obj);
    Clip<double> clip;
    if (!body.set_mesh(rest, faces).ok() || !parse_acclaim<double>(asf, amc, clip).ok()) return false;
    const JointRoles roles = standardise<double>(clip, {}).roles;
    return stage_motion(clip, roles, motion).ok() && place_controls();
  }

  Status perform(const PerformanceSettings<double>& settings, Performance<S>& out) const {
    std::vector<Vec3<double>> resting;
    for (const Vec3<S>& p : body.rest_controls()) resting.push_back(p.template cast<double>());
    PerformanceInput<double> input;
    input.motion = &motion;
    input.pairs = pairs;
    input.rest = resting;
    input.height = static_cast<double>(height);
    input.settings = settings;
    Performance<double> performance;
    const Status status = build_performance(input, performance);
    if (status.ok()) out = performance_cast<S>(performance);
    return status;
  }

 private:
  // Turned to face +Z, on the floor, 1.7 m tall.
  void read_mesh(const std::string& obj) {
    std::istringstream lines(obj);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string kind;
      words >> kind;
      if (kind == "v") {
        double x = 0, y = 0, z = 0;
        words >> x >> y >> z;
        rest.push_back(Vec3<double>(-x, y, -z).template cast<S>());
      } else if (kind == "f") {
        Face face{};
        for (std::int32_t& v : face) {
          std::string corner;
          words >> corner;
          v = static_cast<std::int32_t>(std::stoi(corner)) - 1;
        }
        faces.push_back(face);
      }
    }
    const Bounds<S> box = bounds<S>(rest);
    const S scale = S(1.7) / box.height();
    const Vec3<S> foot((box.low.x() + box.high.x()) / 2, box.low.y(), (box.low.z() + box.high.z()) / 2);
    for (Vec3<S>& p : rest) p = (p - foot) * scale;
    S low = rest[0].y();
    for (const Vec3<S>& p : rest) low = std::min(low, p.y());
    for (Vec3<S>& p : rest) p.y() -= low;
    height = S(1.7);
  }

  // Diagonal hooves follow the same foot, as in a walk on four legs.
  bool place_controls() {
    const std::vector<std::pair<Vec3<S>, const char*>> places = {
        {{S(0.22), S(0.06), S(0.147)}, "rfoot"}, {{S(-0.22), S(0.06), S(0.147)}, "lfoot"},
        {{S(0.2), S(0.06), S(-0.606)}, "lfoot"}, {{S(-0.2), S(0.06), S(-0.606)}, "rfoot"},
        {{S(0), S(1.04), S(0.86)}, "head"},      {{S(0.18), S(1.7), S(0.45)}, "lhand"},
        {{S(-0.18), S(1.7), S(0.45)}, "rhand"},  {{S(0), S(0.66), S(-0.86)}, ""},
    };
    for (const auto& [place, joint] : places) {
      std::size_t nearest = 0;
      for (std::size_t v = 0; v < rest.size(); ++v) {
        if ((rest[v] - place).squaredNorm() < (rest[nearest] - place).squaredNorm()) nearest = v;
      }
      controls.push_back({static_cast<std::int32_t>(nearest), S(0.05) * height});
      const auto& names = motion.clip.skeleton.names;
      const auto found = std::find(names.begin(), names.end(), joint);
      pairs.push_back(found == names.end() ? -1 : static_cast<std::int32_t>(found - names.begin()));
    }
    return body.set_controls(controls).ok();
  }
};

}  // namespace rigless
