// Section 4.1 of the thesis again: Table 4.1, the energy curves of Fig 4.3, the surfaces of Fig 4.1 and 3.6, and how
// much volume each kind of deformation keeps. --out DIR writes them there as JSON; cactus.obj in DIR stands for the
// cactus.
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "harness.h"
#include "meshes.h"
#include "rigless/deform/deformer.h"
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds"  // g++ 12 sees 32-byte loads in Eigen's copies of three doubles
#include "rigless/thesis/thesis_deformer.h"
#pragma GCC diagnostic pop

namespace {

namespace detail = rigless::detail;
using rigless::Control;
using rigless::Deformer;
using rigless::Face;
using rigless::LinearLaw;
using rigless::Span;
using rigless::Vec3;
using rigless_bench::Bench;
using rigless_bench::Mesh;
using Vec3d = Vec3<double>;

constexpr double rigid = std::numeric_limits<double>::infinity();
constexpr double pi = 3.141592653589793;

void check(rigless::Status status) {
  if (!status.ok()) rigless_bench::fail("the deformer refused");
}

// JSON

std::string json(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::isfinite(value) ? text : "null";
}
std::string json(const std::string& text) { return '"' + text + '"'; }
std::string json(const std::vector<std::string>& items) {
  std::string out;
  for (const std::string& item : items) out += (out.empty() ? "" : ",\n") + item;
  return "[" + out + "]";
}
std::string json(const std::vector<std::pair<std::string, std::string>>& members) {
  std::string out;
  for (const auto& [name, value] : members) out += (out.empty() ? "" : ", ") + json(name) + ": " + value;
  return "{" + out + "}";
}
template <class T>
std::string json_numbers(const T& numbers) {
  std::string out;
  for (const auto& x : numbers) out += (out.empty() ? "" : ",") + json(static_cast<double>(x));
  return "[" + out + "]";
}
template <class T>
std::string json_triples(const T& triples) {
  std::string out;
  for (const auto& t : triples) {
    for (const auto& x : t) out += (out.empty() ? "" : ",") + json(static_cast<double>(x));
  }
  return "[" + out + "]";
}

// Where the figures go; nowhere without a folder.
struct Output {
  std::string folder;

  void write(const std::string& name, const std::string& text) const {
    if (folder.empty()) return;
    std::ofstream out(folder + "/" + name);
    out << text << '\n';
    if (!out.flush()) rigless_bench::fail("cannot write " + folder + "/" + name);
  }
};

// Meshes

// The surface of a box of nx x ny x nz cells, 1 wide, 4 tall.
Mesh bar(int nx, int ny, int nz) {
  Mesh mesh;
  mesh.name = "bar";
  std::map<std::array<int, 3>, std::int32_t> at;
  const auto vertex = [&](std::array<int, 3> p) {
    const auto [found, added] = at.try_emplace(p, static_cast<std::int32_t>(mesh.vertices.size()));
    if (added) mesh.vertices.emplace_back(1.0 * p[0] / nx - 0.5, 4.0 * p[1] / ny, 1.0 * p[2] / nz - 0.5);
    return found->second;
  };
  const std::array<int, 3> n = {nx, ny, nz};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
    for (const bool far : {false, true}) {
      for (int i = 0; i < n[b]; ++i) {
        for (int j = 0; j < n[c]; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> p{};
            p[axis] = far ? n[axis] : 0;
            p[b] = i + di;
            p[c] = j + dj;
            return vertex(p);
          };
          const std::int32_t q[] = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
          const std::size_t s = far ? 1 : 3, e = far ? 3 : 1;
          mesh.faces.push_back({q[0], q[s], q[2]});
          mesh.faces.push_back({q[0], q[2], q[e]});
        }
      }
    }
  }
  return mesh;
}

// A closed body of revolution about y: `rows` rings of `around` vertices, their radius and height by t in 0..1, two
// caps.
template <class Profile>
Mesh lathe(const std::string& name, int around, int rows, Profile&& profile) {
  Mesh mesh;
  mesh.name = name;
  for (int r = 0; r < rows; ++r) {
    const auto [radius, y] = profile(1.0 * r / (rows - 1));
    for (int a = 0; a < around; ++a) {
      mesh.vertices.emplace_back(radius * std::sin(2 * pi * a / around), y, radius * std::cos(2 * pi * a / around));
    }
  }
  const auto at = [&](int r, int a) { return static_cast<std::int32_t>(r * around + a % around); };
  const auto low = static_cast<std::int32_t>(mesh.vertices.size()), high = low + 1;
  mesh.vertices.emplace_back(0.0, profile(0.0).second, 0.0);
  mesh.vertices.emplace_back(0.0, profile(1.0).second, 0.0);
  for (int a = 0; a < around; ++a) {
    for (int r = 0; r + 1 < rows; ++r) {
      mesh.faces.push_back({at(r, a), at(r, a + 1), at(r + 1, a)});
      mesh.faces.push_back({at(r, a + 1), at(r + 1, a + 1), at(r + 1, a)});
    }
    mesh.faces.push_back({low, at(0, a + 1), at(0, a)});
    mesh.faces.push_back({high, at(rows - 1, a), at(rows - 1, a + 1)});
  }
  return mesh;
}

Mesh cylinder() {
  return lathe("cylinder", 16, 20, [](double t) { return std::pair(0.5, 4 * t); });
}

// A superegg, 1.2 tall, a little slimmer above.
Mesh egg() {
  return lathe("egg", 48, 49, [](double t) {
    const double angle = pi * (0.02 + 0.96 * t), c = std::cos(angle);
    const double y = std::copysign(std::pow(std::abs(c), 0.75), c);
    return std::pair(0.4 * std::pow(std::sin(angle), 0.75) * (1 + 0.1 * y), 0.6 - 0.6 * y);
  });
}

// One vertex per occupied cell of a grid.
Mesh clustered(const Mesh& mesh, double cell) {
  Mesh out;
  std::map<std::array<long, 3>, std::int32_t> at;
  std::vector<std::int32_t> cluster;
  std::vector<double> members;
  for (const Vec3d& p : mesh.vertices) {
    const std::array<long, 3> key = {std::lround(p.x() / cell), std::lround(p.y() / cell), std::lround(p.z() / cell)};
    const auto [found, added] = at.try_emplace(key, static_cast<std::int32_t>(out.vertices.size()));
    if (added) {
      out.vertices.push_back(Vec3d::Zero());
      members.push_back(0);
    }
    cluster.push_back(found->second);
    const auto c = static_cast<std::size_t>(found->second);
    out.vertices[c] += p;
    members[c] += 1;
  }
  for (std::size_t c = 0; c < members.size(); ++c) out.vertices[c] /= members[c];
  std::set<Face> seen;
  for (const Face& f : mesh.faces) {
    const auto corner = [&](std::size_t k) { return cluster[static_cast<std::size_t>(f[k])]; };
    const Face g = {corner(0), corner(1), corner(2)};
    Face sorted = g;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] != sorted[1] && sorted[1] != sorted[2] && seen.insert(sorted).second) out.faces.push_back(g);
  }
  return out;
}

// The mesh with about this many vertices, by clustering.
Mesh reduced(const Mesh& mesh, std::size_t vertices) {
  double low = 0, high = 0.1 * detail::bounds<double>(mesh.vertices).diagonal();
  for (int k = 0; k < 30; ++k) {
    const double middle = (low + high) / 2;
    (clustered(mesh, middle).vertices.size() > vertices ? low : high) = middle;
  }
  Mesh out = clustered(mesh, high);
  out.name = mesh.name + " reduced";
  return out;
}

// Table 4.1

struct Printed {
  std::string model;
  std::size_t vertices;
  double arap, cartoon;  // frames a second
};

template <class F>
double milliseconds(F&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Frames a second of each, called in turns: the lower quartile of the times, for a machine that does other things too.
std::vector<double> frames_per_second(const std::vector<std::function<void()>>& frames, int rounds) {
  std::vector<std::vector<double>> times(frames.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t f = 0; f < frames.size(); ++f) {
      frames[f]();
      times[f].push_back(milliseconds(frames[f]));
    }
  }
  std::vector<double> out;
  for (auto& t : times) {
    std::sort(t.begin(), t.end());
    out.push_back(1000 / t[t.size() / 4]);
  }
  return out;
}

// As the page uses it, in floats.
Deformer<float> bound(const Mesh& mesh, const rigless_bench::Pull<float>& pull, double elastic) {
  Deformer<float> deformer;
  check(deformer.bind(mesh.rest<float>(), mesh.faces, {static_cast<float>(elastic), {}}));
  check(deformer.set_controls(pull.controls));
  deformer.set_targets(pull.targets);
  return deformer;
}

void cartoon_frame(Deformer<float>& deformer) {
  deformer.step(2);
  deformer.pose(LinearLaw<float>{1.0f});
}

// The thesis to the letter: doubles, one general decomposition per cell, least squares.
using Literal = rigless::ThesisDeformer<double, rigless::SoftRows<double>>;

std::string table_row(Bench& bench, const Mesh& mesh, const Printed& printed) {
  const auto pull = rigless_bench::pull<float>(mesh, 0.1f);
  const auto exact = rigless_bench::pull<double>(mesh, 0.1);
  Deformer<float> arap = bound(mesh, pull, rigid), cartoon = bound(mesh, pull, 0);
  std::vector<std::int32_t> controls;
  for (const auto& control : exact.controls) controls.push_back(control.vertex);
  const auto literal = [&](double elastic) {
    Literal deformer;
    const auto& cells = arap.cells();
    const std::vector<double> weights(cells.weight.begin(), cells.weight.end());
    check(deformer.bind(mesh.vertices, cells.ring, weights, controls, {}, {elastic}));
    deformer.set_targets(exact.targets);
    return deformer;
  };
  Literal literal_arap = literal(rigid), literal_cartoon = literal(0.0);
  const auto fps =
      frames_per_second({[&] { arap.step(3); }, [&] { cartoon_frame(cartoon); }, [&] { literal_arap.step(3); },
                         [&] {
                           literal_cartoon.step(2);
                           literal_cartoon.pose(LinearLaw<double>{1.0});
                         }},
                        bench.small() ? 1 : 30);
  const std::string name = "Table 4.1: " + printed.model + " (" + mesh.name + "): ";
  bench.figure(name + "3 rigid iterations", fps[0], "fps");
  bench.figure(name + "cartoon frame", fps[1], "fps");
  bench.figure(name + "3 rigid iterations to the letter", fps[2], "fps");
  bench.figure(name + "cartoon frame to the letter", fps[3], "fps");
  return json({{"model", json(printed.model)},
               {"printed", json_numbers(std::vector<double>{static_cast<double>(printed.vertices), printed.arap,
                                                            printed.cartoon})},
               {"mesh", json(mesh.name)},
               {"vertices", json(static_cast<double>(mesh.vertices.size()))},
               {"fps", json_numbers(fps)}});
}

// An authored cactus if there is one; what stands for it otherwise has about as many vertices.
Mesh cactus(const Output& output) {
  Mesh mesh = output.folder.empty() ? Mesh() : rigless_bench::load_mesh(output.folder + "/cactus.obj");
  if (mesh.empty()) return rigless_bench::torus(25);
  mesh.name = "our cactus";
  return mesh;
}

void table_4_1(Bench& bench, const Output& output) {
  const Mesh armadillo = rigless_bench::load_mesh(RIGLESS_SHARED_DIR "data/meshes/armadillo.obj");
  std::vector<std::string> rows;
  rows.push_back(table_row(bench, cactus(output), {"Cactus", 620, 86.1, 69.7}));
  if (!bench.small()) {
    rows.push_back(table_row(bench, rigless_bench::torus(75), {"Dinosaur", 5621, 9.0, 7.5}));
    rows.push_back(table_row(bench, armadillo.empty() ? rigless_bench::torus(102) : reduced(armadillo, 10488),
                             {"Armadillo", 10488, 4.1, 3.5}));
    rows.push_back(table_row(bench, rigless_bench::torus(73), {"Bird", 5302, 8.9, 7.6}));
  }
  output.write(std::string("table-4-1-") + rigless_bench::build + ".json", json(rows));
}

// Controls by place

struct Pulled {
  Vec3d at, by;
  double radius = 0;
};

std::int32_t nearest(const Mesh& mesh, const Vec3d& point) {
  std::size_t best = 0;
  for (std::size_t v = 1; v < mesh.vertices.size(); ++v) {
    if ((mesh.vertices[v] - point).norm() < (mesh.vertices[best] - point).norm()) best = v;
  }
  return static_cast<std::int32_t>(best);
}

template <class S>
rigless_bench::Pull<S> pull_of(const Mesh& mesh, const std::vector<Pulled>& controls, bool discs) {
  rigless_bench::Pull<S> out;
  for (const Pulled& c : controls) {
    const std::int32_t v = nearest(mesh, c.at);
    out.controls.push_back({v, static_cast<S>(discs ? c.radius : 0)});
    out.targets.push_back((mesh.vertices[static_cast<std::size_t>(v)] + c.by).cast<S>());
  }
  return out;
}

// Top, right arm, left arm, the middle in front, and the whole bottom of the pot, which stays.
std::vector<Pulled> cactus_controls(const std::array<Vec3d, 4>& by) {
  return {{{0, 1.354, 0}, by[0], 0.17},
          {{-0.5689, 0.9642, 0.0119}, by[1], 0.07},
          {{0.5814, 1.1904, 0.0117}, by[2], 0.07},
          {{0, 0.57, 0.271}, by[3], 0.08},
          {{0, 0, 0}, {0, 0, 0}, 0.3}};
}

using Pose = std::array<Vec3d, 4>;
const Pose stretched = {Vec3d(0, 0.75, 0), Vec3d(-0.3, 0.35, 0), Vec3d(0.3, 0.35, 0), Vec3d(0, 0.2, 0)};
const Pose squashed = {Vec3d(0, -0.48, 0), Vec3d(-0.2, -0.4, 0), Vec3d(0.2, -0.45, 0), Vec3d(0, -0.13, 0.06)};
const Pose bent = {Vec3d(0.75, -0.3, 0.1), Vec3d(0.35, 0.4, 0), Vec3d(0.25, -0.75, 0.1), Vec3d(0.05, 0, 0)};

// Fig 4.3

// Frame, counted from the first guess and between frames where it falls there, at which this share of the drop remains.
double frame_at(const std::vector<double>& energy, double share) {
  const double goal = energy.back() + share * (energy.front() - energy.back());
  for (std::size_t f = 1; f < energy.size(); ++f) {
    if (energy[f] <= goal) {
      return static_cast<double>(f) - (goal - energy[f]) / std::max(energy[f - 1] - energy[f], 1e-300);
    }
  }
  return static_cast<double>(energy.size() - 1);
}

// N_i: mean of the frames that leave 30 % .. 5 % of the drop, every percent.
double frames_needed(const std::vector<double>& energy) {
  double sum = 0;
  for (int percent = 30; percent >= 5; --percent) sum += frame_at(energy, 0.01 * percent);
  return sum / 26;
}

struct Curve {
  std::vector<double> energy;  // of the first guess, then after each frame
  double needed;
};

// The surface is fed from frame to frame; the first guess is the naive Laplacian edit.
Curve energy_curve(const Mesh& mesh, const rigless_bench::Pull<double>& pull, double elastic, int frames) {
  Deformer<double> deformer;
  check(deformer.bind(mesh.vertices, mesh.faces, {elastic, {}}));
  check(deformer.set_controls(pull.controls));
  deformer.set_targets(pull.targets);
  deformer.step(1);
  Curve out;
  out.energy = {deformer.energy()};
  for (int f = 0; f < frames; ++f) {
    deformer.step(elastic == rigid ? 3 : 2);
    out.energy.push_back(deformer.energy());
  }
  out.needed = frames_needed(out.energy);
  return out;
}

std::string json(const Curve& curve) {
  const std::vector<double> drops = {frame_at(curve.energy, 0.3), frame_at(curve.energy, 0.2),
                                     frame_at(curve.energy, 0.1)};
  return json({{"energy", json_numbers(curve.energy)}, {"drops", json_numbers(drops)}, {"needed", json(curve.needed)}});
}

void figure_4_3(Bench& bench, const Output& output) {
  struct Set {
    Mesh mesh;
    std::string name;
    rigless_bench::Pull<double> pull;
  };
  std::vector<Set> sets;
  if (const Mesh mesh = cactus(output); mesh.name == "our cactus") {
    sets.push_back({mesh, "cactus, stretched", pull_of<double>(mesh, cactus_controls(stretched), false)});
    sets.push_back({mesh, "cactus, squashed", pull_of<double>(mesh, cactus_controls(squashed), false)});
    sets.push_back({mesh, "cactus, bent", pull_of<double>(mesh, cactus_controls(bent), false)});
  }
  const auto ten = [&](const Mesh& mesh, const std::string& name, double amplitude) {
    char text[80];
    std::snprintf(text, sizeof text, "%s, ten controls by %.1f", name.c_str(), amplitude);
    sets.push_back({mesh, text, rigless_bench::pull<double>(mesh, amplitude)});
  };
  ten(rigless_bench::torus(bench.small() ? 16 : 54), "torus", 0.1);
  ten(rigless_bench::torus(bench.small() ? 16 : 54), "torus", 0.3);
  if (!bench.small()) {
    const std::vector<std::pair<std::string, std::string>> others = {{"cheburashka.off", "cheburashka"},
                                                                     {"cow.obj", "cow"}};
    for (const auto& [file, name] : others) {
      const Mesh mesh = rigless_bench::load_mesh(RIGLESS_SHARED_DIR "data/meshes/" + file);
      if (!mesh.empty()) ten(mesh, name, 0.1);
      if (!mesh.empty()) ten(mesh, name, 0.3);
    }
  }
  std::vector<std::string> out;
  for (const Set& set : sets) {
    const Curve arap = energy_curve(set.mesh, set.pull, rigid, 60), cartoon = energy_curve(set.mesh, set.pull, 0.0, 60);
    rigless_bench::Pull<float> pull;
    for (const auto& control : set.pull.controls) pull.controls.push_back({control.vertex, 0.0f});
    for (const Vec3d& target : set.pull.targets) pull.targets.push_back(target.cast<float>());
    Deformer<float> fast_arap = bound(set.mesh, pull, rigid), fast_cartoon = bound(set.mesh, pull, 0);
    const auto fps =
        frames_per_second({[&] { fast_arap.step(3); }, [&] { cartoon_frame(fast_cartoon); }}, bench.small() ? 1 : 40);
    const double n = cartoon.needed / arap.needed, delta = fps[0] / fps[1];
    bench.figure("Fig 4.3: " + set.name + ": N cartoon / N rigid", n, "x");
    bench.figure("Fig 4.3: " + set.name + ": N Delta cartoon / N Delta rigid", n * delta, "x");
    out.push_back(
        json({{"name", json(set.name)}, {"arap", json(arap)}, {"cartoon", json(cartoon)}, {"delta", json(delta)}}));
  }
  output.write("fig-4-3.json", json(out));
}

// Volumes

// The six poses of a body 4 tall whose two ends are held.
Vec3d move(const std::string& pose, const Vec3d& p) {
  const double a = (pose == "bend 90" ? 90 : 135) * pi / 180;
  if (pose == "bend 90") {
    const Vec3d rolled(p.x() * std::cos(a) + (p.y() - 4) * std::sin(a),
                       -p.x() * std::sin(a) + (p.y() - 4) * std::cos(a), p.z());
    const double radius = 4 / a;  // the middle line keeps its length
    return p.y() < 2 ? p : Vec3d(rolled + Vec3d(radius * (1 - std::cos(a)), radius * std::sin(a), 0));
  }
  if (pose == "twist 135") {
    return p.y() < 2
               ? p
               : Vec3d(p.x() * std::cos(a) + p.z() * std::sin(a), p.y(), -p.x() * std::sin(a) + p.z() * std::cos(a));
  }
  return {p.x(), p.y() * std::atof(pose.c_str()), p.z()};
}

// Ratio to the rest in the order of the columns of the table.
std::vector<double> volumes(const Mesh& mesh, const std::string& pose) {
  std::vector<Control<double>> controls;
  std::vector<Vec3d> targets;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vec3d& p = mesh.vertices[v];
    if (p.y() > 1e-9 && p.y() < 4 - 1e-9) continue;
    controls.push_back({static_cast<std::int32_t>(v), 0.0});
    targets.push_back(move(pose, p));
  }
  const auto converged = [&](double elastic, int iterations) {
    Deformer<double> deformer;
    check(deformer.bind(mesh.vertices, mesh.faces, {elastic, {}}));
    check(deformer.set_controls(controls));
    deformer.set_targets(targets);
    deformer.step(1 + iterations);  // the first from rest is the naive Laplacian edit
    return deformer;
  };
  const double rest = detail::signed_volume<double>(mesh.vertices, mesh.faces);
  const auto ratio = [&](Span<const Vec3d> surface) {
    return detail::signed_volume<double>(surface, mesh.faces) / rest;
  };
  const auto posed = [&](Deformer<double>& deformer, const auto& law) {
    deformer.pose(law);
    return ratio(deformer.positions());
  };
  Deformer<double> arap = converged(rigid, 40), thesis = converged(0.0, 40), brief = converged(0.0, 2),
                   elastic = converged(0.5, 40);
  using Linear = LinearLaw<double>;
  using Power = rigless::PowerLaw<double>;
  return {ratio(arap.shape()),        ratio(thesis.shape()),      posed(thesis, Linear{0.0}),
          posed(thesis, Linear{1.0}), posed(thesis, Linear{3.0}), posed(brief, Linear{1.0}),
          ratio(elastic.shape()),     posed(elastic, Power{1.0}), posed(arap, Linear{1.0})};
}

void volume_table(Bench& bench, const Output& output) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  struct Row {
    Mesh mesh;
    std::string pose;
    std::vector<double> reference;
  };
  const std::vector<Row> rows = {{bar(4, 16, 4), "1.5", {1.5, 3.56, 1.70, 1.29, 0.99, 1.24, 2.17, 1.22, 1.16}},
                                 {cylinder(), "1.5", {1.5, 3.65, 1.63, 1.20, 0.88, 1.19, 2.22, 1.17, 1.12}},
                                 {bar(4, 16, 4), "2.0", {2.0, 9.2, none, 1.59, 1.18, none, 3.90, 1.42, 1.30}},
                                 {cylinder(), "2.0", {}},
                                 {bar(4, 16, 4), "0.6", {0.6, 0.325, 0.51, 0.81, 2.78, 0.79, 0.41, 0.78, 0.86}},
                                 {cylinder(), "0.6", {0.6, 0.316, 0.54, 0.91, 3.33, 0.84, 0.40, 0.83, 0.89}},
                                 {bar(4, 16, 4), "bend 90", {0.939, 1.04, 0.96, 0.955, 1.04, 0.915, 0.96, 0.95, 0.945}},
                                 {cylinder(), "bend 90", {}},
                                 {bar(4, 16, 4), "twist 135", {0.833, 1.09, 0.86, 0.89, 1.38, 0.85, none, none, none}},
                                 {cylinder(), "twist 135", {}}};
  std::vector<std::string> out;
  for (const Row& row : rows) {
    const std::vector<double> ours = volumes(row.mesh, row.pose);
    bench.figure("volume: " + row.mesh.name + " " + row.pose + ": rigid", ours[0], "of rest");
    bench.figure("volume: " + row.mesh.name + " " + row.pose + ": mu 0.5 with lambda_v 1", ours[7], "of rest");
    out.push_back(json({{"body", json(row.mesh.name)},
                        {"pose", json(row.pose)},
                        {"ours", json_numbers(ours)},
                        {"reference", json_numbers(row.reference)}}));
  }
  output.write("volumes.json", json(out));
}

// Fig 4.1 and 3.6

std::string json_surface(const Mesh& mesh, const std::string& name, Span<const Vec3d> surface) {
  const double rest = detail::signed_volume<double>(mesh.vertices, mesh.faces);
  return json({{"name", json(name)},
               {"volume", json(detail::signed_volume<double>(surface, mesh.faces) / rest)},
               {"positions", json_triples(surface)}});
}

std::string json_surfaces(const Mesh& mesh, const std::vector<Pulled>& controls,
                          const std::vector<std::string>& surfaces) {
  std::vector<std::int32_t> vertices;
  for (const Pulled& c : controls) vertices.push_back(nearest(mesh, c.at));
  return json(
      {{"faces", json_triples(mesh.faces)}, {"controls", json_numbers(vertices)}, {"surfaces", json(surfaces)}});
}

// Large discs keep level, small ones turn with their surroundings.
Deformer<double> relaxed(const Mesh& mesh, const std::vector<Pulled>& controls, double elastic, int iterations) {
  const auto pull = pull_of<double>(mesh, controls, true);
  Deformer<double> deformer;
  check(deformer.bind(mesh.vertices, mesh.faces, {elastic, {}}));
  check(deformer.set_controls(pull.controls));
  deformer.set_targets(pull.targets);
  for (std::size_t c = 0; c < controls.size(); ++c) {
    if (controls[c].radius > 0.1) deformer.turn(static_cast<std::int32_t>(c), rigless::Mat3<double>::Identity());
  }
  deformer.start();
  deformer.relax(iterations);
  return deformer;
}

void figure_4_1(const Output& output) {
  const Mesh mesh = cactus(output);
  std::vector<std::string> surfaces = {json_surface(mesh, "rest", mesh.vertices)};
  const std::vector<std::pair<std::string, Pose>> poses = {{"stretched", stretched}, {"squashed", squashed}};
  for (const auto& [name, by] : poses) {
    surfaces.push_back(json_surface(mesh, name + ", ARAP", relaxed(mesh, cactus_controls(by), rigid, 100).shape()));
    for (const double elastic : {0.0, 0.5}) {
      Deformer<double> cartoon = relaxed(mesh, cactus_controls(by), elastic, elastic > 0 ? 100 : 2);
      cartoon.pose(1.0);
      surfaces.push_back(json_surface(mesh, name + (elastic > 0 ? ", mu 0.5" : ", mu 0"), cartoon.positions()));
    }
  }
  output.write("fig-4-1.json", json_surfaces(mesh, cactus_controls(stretched), surfaces));
}

void figure_3_6(const Output& output) {
  const Mesh mesh = egg();
  const auto controls = [](double up) {
    return std::vector<Pulled>{{{0, 0, 0}, {0, 0, 0}, 0.35}, {{0, 1.2, 0}, {0, up, 0}, 0.3}};
  };
  std::vector<std::string> surfaces = {json_surface(mesh, "rest", mesh.vertices)};
  const std::vector<std::pair<std::string, double>> poses = {{"squashed", -0.45}, {"stretched", 0.5}};
  for (const auto& [name, up] : poses) {
    Deformer<double> cartoon = relaxed(mesh, controls(up), 0.0, 2);
    for (const double lambda : {0.0, 3.0}) {
      cartoon.pose(lambda);
      surfaces.push_back(json_surface(mesh, name + (lambda > 0 ? ", 3" : ", 0"), cartoon.positions()));
    }
  }
  output.write("fig-3-6.json", json_surfaces(mesh, controls(0), surfaces));
}

}  // namespace

int main(int argc, char** argv) {
  Bench bench(argc, argv);
  Output output;
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], "--out") == 0) output.folder = argv[i + 1];
  }
  table_4_1(bench, output);
  figure_4_3(bench, output);
  volume_table(bench, output);
  figure_4_1(output);
  figure_3_6(output);
}
