// The deformer by itself and against the textbook: an iteration and its parts, a frame, binding, controls that come and
// go, memory.
#include <cmath>
#include <limits>

#include "harness.h"
#include "meshes.h"
#include "rigless/deform/deformer.h"
#include "rigless/thesis/cell_fit.h"
#include "textbook.h"

namespace {

namespace detail = rigless::detail;
using rigless::Control;
using rigless::Deformer;
using rigless::Span;
using rigless_bench::Bench;
using rigless_bench::Mesh;
using rigless_bench::Pull;
using Vec3f = rigless::Vec3<float>;

constexpr float rigid = std::numeric_limits<float>::infinity();

void check(rigless::Status status) {
  if (!status.ok()) rigless_bench::fail("the deformer refused");
}

Deformer<float> bound(const Mesh& mesh, const Pull<float>& pull, float elastic) {
  Deformer<float> deformer;
  check(deformer.bind(mesh.rest<float>(), mesh.faces, {elastic, {}}));
  check(deformer.set_controls(pull.controls));
  deformer.set_targets(pull.targets);
  return deformer;
}

// An iteration against the textbook's, after both went 30 from the same start to the same energy.
void against_textbook(Bench& bench, const Mesh& mesh) {
  const Pull<float> pull = rigless_bench::pull<float>(mesh, 0.1f);
  Deformer<float> ours = bound(mesh, pull, rigid);
  const rigless::Cells<double> cells = rigless_bench::in_double(ours.cells());
  std::vector<std::int32_t> controls;
  for (const auto& control : pull.controls) controls.push_back(control.vertex);
  rigless_bench::TextbookArap textbook(cells, controls);
  if (!textbook.ok()) rigless_bench::fail("the textbook's system is singular");
  textbook.set_targets(rigless_bench::in_double(Span<const Vec3f>(pull.targets)));
  ours.start();
  textbook.set_shape(rigless_bench::in_double(ours.shape()));
  ours.step(30);
  for (int it = 0; it < 30; ++it) textbook.step();
  const detail::ElasticScale<double> elastic{std::numeric_limits<double>::infinity()};
  const double e = rigless::shape_energy<double>(cells, rigless_bench::in_double(ours.shape()), elastic);
  const double reference = rigless::shape_energy<double>(cells, textbook.shape(), elastic);
  const double apart = std::abs(e / reference - 1);
  bench.figure(mesh.name + ": energy after 30 iterations: off the textbook's", apart, "relative");
  if (!(apart < 1e-5)) rigless_bench::fail("not the textbook's energy");
  const bool large = mesh.vertices.size() > 20000;
  bench.compare(mesh.name, {{"iteration", [&] { ours.step(1); }}, {"textbook iteration", [&] { textbook.step(); }}},
                large ? 9 : 15);
}

// What a frame costs in iterations; controls are discs as in the product.
void frames(Bench& bench, const Mesh& mesh) {
  const Pull<float> pull = rigless_bench::pull<float>(mesh, 0.1f, 0.05f),
                    single = rigless_bench::pull<float>(mesh, 0.1f);
  Deformer<float> arap = bound(mesh, single, rigid), cartoon = bound(mesh, single, 0.5f),
                  discs = bound(mesh, pull, 0.5f);
  for (auto* deformer : {&arap, &cartoon, &discs}) {
    deformer->start();
    deformer->relax(10);
  }
  const auto frame = [](Deformer<float>& deformer) {
    deformer.step(2);
    deformer.pose(1.0f);
  };
  bench.compare(mesh.name,
                {{"3 iterations", [&] { arap.step(3); }},
                 {"cartoon frame of 2 iterations and pose", [&] { frame(cartoon); }},
                 {"cartoon frame with discs of 5 % height", [&] { frame(discs); }}},
                25);
  bench.compare(mesh.name,
                {{"10 iterations", [&] { discs.step(10); }}, {"10 iterations with momentum", [&] { discs.relax(10); }}},
                9);
  const Deformer<float>& still = discs;
  bench.run(mesh.name + ": set_targets", [&] { discs.set_targets(pull.targets); });
  bench.run(mesh.name + ": pose", [&] { discs.pose(1.0f); });
  bench.run(mesh.name + ": reset", [&] { discs.reset(); });
  bench.run(mesh.name + ": start", [&] { discs.start(); });
  bench.run(
      mesh.name + ": frame from rest (start and 20 with momentum and pose)",
      [&] {
        discs.start();
        discs.relax(20);
        discs.pose(1.0f);
      },
      15);
  bench.figure(mesh.name + ": memory", static_cast<double>(still.bytes()) / still.vertices(), "bytes a vertex");
}

// As fast as one thread can read.
float sum(const std::vector<float>& numbers) {
  using Lanes = detail::simd::Lanes<float>;
  constexpr std::size_t width = detail::simd::width<float>, ahead = 8;
  Lanes sums[ahead] = {};
  for (std::size_t i = 0; i + ahead * width <= numbers.size(); i += ahead * width) {
    for (std::size_t k = 0; k < ahead; ++k) {
      Lanes v;
      std::memcpy(&v, numbers.data() + i + k * width, sizeof v);
      sums[k] += v;
    }
  }
  for (std::size_t k = 1; k < ahead; ++k) sums[0] += sums[k];
  float total = 0;
  for (std::size_t k = 0; k < width; ++k) total += sums[0][k];
  return total;
}

// The two halves of an iteration, on their own data.
void parts(Bench& bench, const Mesh& mesh) {
  const auto rest = mesh.rest<float>();
  rigless::Cells<float> cells;
  cells.rest = rest;
  const auto n = static_cast<std::int32_t>(rest.size());
  const std::string name = mesh.name + ": bind: ";
  const std::size_t runs = 7;
  bench.run(
      name + "one-rings", [&] { cells.ring = detail::one_ring(mesh.faces, n); }, runs);
  bench.run(
      name + "look for loose shells", [&] { detail::tie_shells<float>(rest, cells.ring); }, runs);
  bench.run(
      name + "weights", [&] { cells.weight = detail::cotangent_weights<float>(rest, mesh.faces, cells.ring); }, runs);
  detail::measure_cells(cells);
  bench.run(
      name + "ordering", [&] { detail::minimum_degree_order(cells.ring.first, cells.ring.neighbor); }, runs);
  detail::SupernodalLdlt<float> ldlt;
  bench.run(
      name + "analysis with ordering", [&] { ldlt.analyze(cells.ring.first, cells.ring.neighbor); }, runs);
  detail::CellSlices<float> slices;
  bench.run(
      name + "slices", [&] { slices = detail::slice_cells(cells, ldlt.place(), ldlt.vertex_at()); }, runs);

  std::vector<float> diagonal(rest.size(), 0.0f), coupling(cells.weight.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    for (auto k = static_cast<std::size_t>(cells.ring.first[i]); k < static_cast<std::size_t>(cells.ring.first[i + 1]);
         ++k) {
      diagonal[i] += cells.weight[k];
      coupling[k] = -cells.weight[k];
    }
  }
  diagonal[0] += 1.0f;
  bench.run(
      name + "factorisation", [&] { check(ldlt.factorize(diagonal, coupling)); }, runs);

  using Quad = detail::simd::Quad<float>;
  std::vector<Quad> x(rest.size() + 1, Quad{}), r(rest.size() + 1, Quad{});
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const Vec3f& p = rest[static_cast<std::size_t>(ldlt.vertex_at()[i])];
    x[i] = Quad{1.1f * p.x(), 0.9f * p.y() + 0.1f * p.x(), p.z(), 0.0f};
  }
  const std::vector<float> factor(static_cast<std::size_t>(ldlt.stored()), 1.0f);
  const auto read_twice = [&] {
    if (sum(factor) + sum(factor) < 1.0f) rigless_bench::fail("a factor without numbers");
  };
  const double per_vertex = 1e6 / static_cast<double>(n);
  const double local = bench.run(mesh.name + ": local step", [&] {
    detail::shape_step<false>(slices, x.data(), detail::ElasticScale<float>{rigid}, r.data());
  });
  const auto solve_once = [&] {
    std::copy(x.begin(), x.end(), r.begin());
    ldlt.solve(r.data());
  };
  const double solve = bench.run(mesh.name + ": solve", solve_once);
  bench.compare(mesh.name, {{"reading the factor twice", read_twice}, {"the solve", solve_once}}, 9);
  bench.figure(mesh.name + ": local step for each vertex", local * per_vertex, "ns");
  bench.figure(mesh.name + ": solve for each vertex", solve * per_vertex, "ns");
  bench.figure(mesh.name + ": factor", static_cast<double>(ldlt.stored()) / n, "numbers a vertex");
}

// A disc of about `size` vertices around this one.
Control<float> disc(const rigless::Cells<float>& cells, std::int32_t vertex, std::size_t size) {
  const auto reached = detail::vertices_within<float>(cells.rest, cells.ring, vertex, 1e30f);
  return {vertex, reached[std::min(size, reached.size()) - 1].distance};
}

void controls(Bench& bench, const Mesh& mesh) {
  const Pull<float> pull = rigless_bench::pull<float>(mesh, 0.1f, 0.05f);
  const auto rest = mesh.rest<float>();
  Deformer<float> deformer;
  const std::size_t runs = mesh.vertices.size() > 20000 ? 7 : 15;
  bench.run(
      mesh.name + ": bind", [&] { check(deformer.bind(rest, mesh.faces)); }, runs);
  bench.run(
      mesh.name + ": bind and first set_controls",
      [&] {
        check(deformer.bind(rest, mesh.faces));
        check(deformer.set_controls(pull.controls));
      },
      runs);
  // Where the new one sits in the elimination tree decides what it costs, so try it in many places.
  const auto n = static_cast<std::size_t>(deformer.vertices());
  for (const std::size_t size : {std::size_t{1}, std::size_t{150}}) {
    std::vector<std::vector<Control<float>>> more;
    for (std::size_t k = 0; k < 12; ++k) {
      more.push_back(pull.controls);
      more.back().push_back(disc(deformer.cells(), static_cast<std::int32_t>((k * n + n / 3) / 12), size));
    }
    const std::string what = size == 1 ? "a vertex" : "a disc of 150 vertices";
    std::size_t k = 0;
    const auto add = [&] { check(deformer.set_controls(more[k++ % more.size()])); };
    const auto remove = [&] { check(deformer.set_controls(pull.controls)); };
    bench.run(mesh.name + ": add " + what, add, 60, remove);
    bench.run(mesh.name + ": remove " + what, remove, 60, add);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Bench bench(argc, argv);
  std::vector<Mesh> all;
  if (!bench.small()) all = rigless_bench::meshes({"spot.obj", "cheburashka.off", "armadillo.obj"}, {});
  for (const std::int32_t n : bench.small() ? std::vector{24} : std::vector{54, 208}) {
    all.push_back(rigless_bench::torus(n));
  }
  for (const Mesh& mesh : all) {
    against_textbook(bench, mesh);
    frames(bench, mesh);
    parts(bench, mesh);
    controls(bench, mesh);
  }
}
