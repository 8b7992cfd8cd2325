// Bodies and motions with which the whole way is tested, from the files to the vertices of a frame.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "rigless/motion/parse_acclaim.h"
#include "rigless/motion/parse_bvh.h"
#include "rigless/motion/standardise.h"
#include "rigless/scene/body.h"
#include "rigless/scene/performance_builder.h"
#include "support/glb.h"
#include "support/shared_data.h"

namespace rigless::test {

// A mesh that stands on the floor, 1.7 m tall and facing +Z, with controls, what moves them, and poses to learn from.
template <class S>
struct Dancer {
  static constexpr S height = S(1.7);
  Body<S> body;
  std::vector<Control<S>> controls;
  std::vector<std::int32_t> pairs;
  StagedMotion<double> motion;
  ExampleStorage<double> poses;

  Status perform(const PerformanceSettings<double>& settings, Performance<S>& out) const {
    std::vector<Vec3<double>> resting;
    for (const Vec3<S>& p : body.rest_controls()) resting.push_back(p.template cast<double>());
    PerformanceInput<double> input;
    input.motion = &motion;
    input.pairs = pairs;
    input.rest = resting;
    input.height = static_cast<double>(height);
    input.examples = poses.view();
    input.settings = settings;
    Performance<double> performance;
    const Status status = build_performance(input, performance);
    if (status.ok()) out = performance_cast<S>(performance);
    return status;
  }

 protected:
  void set_motion(Clip<double> clip, Span<const Vec3<double>> rest) {
    const JointRoles roles = standardise<double>(clip, rest).roles;
    REQUIRE(stage_motion(clip, roles, motion).ok());
  }

  // Returns what a length of the file is multiplied by.
  S set_surface(Surface<S> surface) {
    const detail::Bounds<S> box = detail::bounds<S>(surface.vertices);
    const S scale = height / box.height();
    const Vec3<S> foot((box.low.x() + box.high.x()) / 2, box.low.y(), (box.low.z() + box.high.z()) / 2);
    for (Vec3<S>& p : surface.vertices) p = (p - foot) * scale;
    S low = surface.vertices[0].y();
    for (const Vec3<S>& p : surface.vertices) low = std::min(low, p.y());
    for (Vec3<S>& p : surface.vertices) p.y() -= low;
    REQUIRE(body.set_mesh(surface.vertices, surface.faces).ok());
    return scale;
  }

  std::int32_t joint(const std::string& name) const {
    const auto& names = motion.clip.skeleton.names;
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<std::int32_t>(found - names.begin());
  }

  // At the nearest vertex.
  void add_control(const Vec3<S>& place, S radius, const std::string& joint_name) {
    const auto distance = [&](const Vec3<S>& p) { return (p - place).squaredNorm(); };
    const auto nearest = std::min_element(body.rest().begin(), body.rest().end(),
                                          [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    controls.push_back({static_cast<std::int32_t>(nearest - body.rest().begin()), radius});
    pairs.push_back(joint(joint_name));
  }
};

// The cactus that comes with the page, its points and its poses.
template <class S>
struct Cactus : Dancer<S> {
  explicit Cactus(const std::string& motion_file) {
    const std::string assets = RIGLESS_TEST_DIR "../web/assets/";
    Clip<double> clip;
    ParseNotes notes;
    REQUIRE(parse_bvh(json::read_text(assets + "motions/" + motion_file), clip, &notes).ok());
    this->set_motion(std::move(clip), notes.rest);
    Surface<S> surface = read_glb<S>(json::read_text(assets + "cactus/cactus.glb"));
    REQUIRE_FALSE(surface.faces.empty());
    const S scale = this->set_surface(std::move(surface));

    const json::Value project = json::parse_file(assets + "cactus/project.json");
    const json::Value& points = project["points"];
    REQUIRE(points.size() == 6);
    for (const json::Value& point : points.array()) {
      this->add_control(point["position"].template vec3<S>() * scale, S(point["radius"].number()) * scale,
                        point["joint"].string());
      REQUIRE(this->pairs.back() >= 0);
    }
    for (const json::Value& pose : project["examples"].array()) {
      for (const std::string& name : this->motion.clip.skeleton.names)
        this->poses.joints.push_back(pose["joints"][name].template vec3<double>());
      for (const json::Value& point : points.array()) {
        const Vec3<double> place = pose["points"][point["id"].string()].template vec3<double>();
        this->poses.controls.push_back(place * double(scale));
      }
    }
    REQUIRE(this->body.set_controls(this->controls).ok());
  }
};

// A cow that walks like a man, taught nothing; diagonal hooves follow the same foot, as in a walk on four legs. Needs
// the shared data.
template <class S>
struct SpotWalk : Dancer<S> {
  SpotWalk() {
    Clip<double> clip;
    REQUIRE(parse_acclaim<double>(shared_text("motions/02.asf"), shared_text("motions/02_01.amc"), clip).ok());
    this->set_motion(std::move(clip), {});
    this->set_surface(read_obj(shared_text("meshes/spot.obj")));
    const std::vector<std::pair<Vec3<S>, const char*>> places = {
        {{S(0.22), S(0.06), S(0.147)}, "rfoot"}, {{S(-0.22), S(0.06), S(0.147)}, "lfoot"},
        {{S(0.2), S(0.06), S(-0.606)}, "lfoot"}, {{S(-0.2), S(0.06), S(-0.606)}, "rfoot"},
        {{S(0), S(1.04), S(0.86)}, "head"},      {{S(0.18), S(1.7), S(0.45)}, "lhand"},
        {{S(-0.18), S(1.7), S(0.45)}, "rhand"},  {{S(0), S(0.66), S(-0.86)}, ""},
    };
    for (const auto& [place, joint_name] : places) this->add_control(place, S(0.05) * this->height, joint_name);
    REQUIRE(this->body.set_controls(this->controls).ok());
  }

 private:
  // Turned to face +Z.
  static Surface<S> read_obj(const std::string& obj) {
    Surface<S> surface;
    std::istringstream lines(obj);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string kind;
      words >> kind;
      if (kind == "v") {
        double x = 0, y = 0, z = 0;
        words >> x >> y >> z;
        surface.vertices.push_back(Vec3<double>(-x, y, -z).template cast<S>());
      } else if (kind == "f") {
        Face face{};
        for (std::int32_t& v : face) {
          std::string corner;
          words >> corner;
          v = static_cast<std::int32_t>(std::stoi(corner)) - 1;
        }
        surface.faces.push_back(face);
      }
    }
    return surface;
  }
};

}  // namespace rigless::test
