// How many iterations a drag takes, plain and with momentum; that the energy never rises; and that thousands of random
// drags leave every surface sane. --frames N: how many on each mesh, 1000 unless said.
#include <cmath>
#include <limits>
#include <random>

#include "harness.h"
#include "meshes.h"
#include "rigless/deform/deformer.h"

namespace {

using rigless::Deformer;
using rigless_bench::Bench;
using rigless_bench::Mesh;
using rigless_bench::Pull;
using Vec3f = rigless::Vec3<float>;

Deformer<float> bound(const Mesh& mesh, const Pull<float>& pull, float elastic) {
  Deformer<float> deformer;
  if (!deformer.bind(mesh.rest<float>(), mesh.faces, {elastic, {}}).ok() ||
      !deformer.set_controls(pull.controls).ok()) {
    rigless_bench::fail("the deformer refused");
  }
  deformer.set_targets(pull.targets);
  return deformer;
}

// The energy of the surface after 0, 1, 2 .. `iterations`, plain.
std::vector<double> plain_energies(Deformer<float>& deformer, int iterations) {
  deformer.start();
  std::vector<double> energies = {deformer.energy()};
  for (int i = 0; i < iterations; ++i) {
    deformer.step(1);
    energies.push_back(deformer.energy());
  }
  return energies;
}

double relaxed_energy(Deformer<float>& deformer, int iterations) {
  deformer.start();
  deformer.relax(iterations);
  return deformer.energy();
}

// Fewest iterations with momentum that reach `goal`: doubling, then halving the gap.
int momentum_iterations(Deformer<float>& deformer, double goal, int limit) {
  deformer.start();
  if (deformer.energy() <= goal) return 0;
  int low = 0, high = 1;
  while (high < limit && relaxed_energy(deformer, high) > goal) {
    low = high;
    high *= 2;
  }
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (relaxed_energy(deformer, middle) > goal ? low : high) = middle;
  }
  return high;
}

// The largest rise from one energy to the next, as a share of the first.
double worst_rise(const std::vector<double>& energies) {
  double worst = 0;
  for (std::size_t i = 1; i < energies.size(); ++i) {
    worst = std::max(worst, (energies[i] - energies[i - 1]) / energies[0]);
  }
  return worst;
}

void converge(Bench& bench, const Mesh& mesh) {
  const bool large = mesh.vertices.size() > 20000;
  const int limit = bench.small() ? 40 : large ? 400 : 2000;
  for (const float radius : {0.0f, 0.05f}) {
    for (const float amplitude : {0.1f, 0.3f, 0.6f}) {
      for (const float elastic : {0.5f, std::numeric_limits<float>::infinity()}) {
        const Pull<float> pull = rigless_bench::pull<float>(mesh, amplitude, radius);
        Deformer<float> deformer = bound(mesh, pull, elastic);
        char text[160];
        std::snprintf(text, sizeof text, "%s: %s dragged by %.1f of the height with mu %.1f: ", mesh.name.c_str(),
                      radius > 0 ? "discs" : "vertices", static_cast<double>(amplitude), static_cast<double>(elastic));
        const std::string name = text;
        const std::vector<double> plain = plain_energies(deformer, limit);
        const double best = std::min(plain.back(), relaxed_energy(deformer, limit / 2));
        const double goal = 1.01 * best;
        const auto reached = std::find_if(plain.begin(), plain.end(), [&](double e) { return e <= goal; });
        const auto n_plain = static_cast<int>(reached - plain.begin());
        const int n_momentum = momentum_iterations(deformer, goal, limit);
        bench.figure(name + "to 1 % of the best energy", n_plain, "iterations");
        bench.figure(name + "to 1 % with momentum", n_momentum, "iterations");
        bench.figure(name + "with momentum / plain", static_cast<double>(n_momentum) / std::max(n_plain, 1), "x");
        bench.figure(name + "worst rise of the energy", worst_rise(plain), "relative");
        if (worst_rise(plain) > 1e-6) rigless_bench::fail(name + "the energy rose");
      }
    }
  }
}

// Controls wander, and now and then jump, inside a box twice the size of the model.
void soak(Bench& bench, const Mesh& mesh, int frames) {
  const Pull<float> pull = rigless_bench::pull<float>(mesh, 0.0f, 0.05f);
  Deformer<float> deformer = bound(mesh, pull, 0.5f);
  const auto rest = mesh.rest<float>();
  const auto box = rigless::detail::bounds<float>(rest);
  const Vec3f middle = (box.low + box.high) / 2.0f;
  std::mt19937 random(1);
  const auto anywhere = [&](float size) {
    Vec3f p;
    for (int k = 0; k < 3; ++k) p[k] = size * (static_cast<float>(random() % 2001) / 1000.0f - 1.0f);
    return p;
  };
  std::vector<Vec3f> targets = pull.targets;
  double rise = 0, farthest = 0;
  deformer.start();
  for (int frame = 0; frame < frames; ++frame) {
    for (std::size_t c = 0; c < targets.size(); ++c) {
      const bool jump = random() % 200 == 0;
      Vec3f p = jump ? Vec3f(pull.targets[c] + anywhere(0.3f * box.diagonal()))
                     : Vec3f(targets[c] + anywhere(0.02f * box.diagonal()));
      p += 0.01f * (pull.targets[c] - p);
      targets[c] = p.cwiseMax(middle - box.extent()).cwiseMin(middle + box.extent());
    }
    deformer.set_targets(targets);
    if (frame % 100 == 99) {
      deformer.start();
      deformer.relax(20);
    } else {
      deformer.step(1);  // brings the controls to their targets, which may cost energy; from there it must not rise
      const double before = deformer.energy();
      deformer.step(1);
      rise = std::max(rise, (deformer.energy() - before) / before);
    }
    deformer.pose(1.0f);
    for (const auto surface : {deformer.shape(), deformer.positions()}) {
      for (const Vec3f& p : surface) {
        if (!p.allFinite()) rigless_bench::fail(mesh.name + ": not finite in frame " + std::to_string(frame));
        farthest = std::max(farthest, static_cast<double>((p - middle).norm()));
      }
    }
    if (farthest > 3 * static_cast<double>(box.diagonal())) {
      rigless_bench::fail(mesh.name + ": beyond three diagonals in frame " + std::to_string(frame));
    }
  }
  bench.figure(mesh.name + ": soak", frames, "frames");
  bench.figure(mesh.name + ": soak: farthest from the middle", farthest / static_cast<double>(box.diagonal()),
               "diagonals");
  bench.figure(mesh.name + ": soak: worst rise of the energy in an iteration", rise, "relative");
  if (rise > 1e-5) rigless_bench::fail(mesh.name + ": the energy rose");
}

}  // namespace

int main(int argc, char** argv) {
  Bench bench(argc, argv);
  if (bench.small()) {
    const Mesh mesh = rigless_bench::torus(24);
    converge(bench, mesh);
    soak(bench, mesh, 50);
    return 0;
  }
  for (const Mesh& mesh : rigless_bench::meshes({"spot.obj", "armadillo.obj"}, {54})) converge(bench, mesh);
  const std::vector<std::string> every = {"knight.off", "cow.obj", "spot.obj", "cheburashka.off", "armadillo.obj"};
  int frames = 1000;
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], "--frames") == 0) frames = std::atoi(argv[i + 1]);
  }
  for (const Mesh& mesh : rigless_bench::meshes(every, {54})) soak(bench, mesh, frames);
}
