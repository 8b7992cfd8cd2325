// The deformer against CGAL's as-rigid-as-possible deformation: same mesh, same weights, same controls, same energy.
#define CGAL_NDEBUG
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <cmath>
#include <limits>
#include <memory>

#include "harness.h"
#include "meshes.h"
#include "rigless/deform/deformer.h"
#include "rigless/thesis/cell_fit.h"
#include "textbook.h"

namespace {

namespace detail = rigless::detail;
using rigless::Deformer;
using rigless_bench::Bench;
using rigless_bench::Mesh;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

// The deformer's weights in CGAL's clothes.
struct SameWeights {
  using Triangle_mesh = SurfaceMesh;

  const rigless::Cells<double>* cells = nullptr;

  template <class PointMap>
  double operator()(SurfaceMesh::Halfedge_index h, const SurfaceMesh& mesh, const PointMap&) const {
    const auto i = static_cast<std::int32_t>(mesh.source(h)), j = static_cast<std::int32_t>(mesh.target(h));
    return cells->weight[static_cast<std::size_t>(cells->ring.slot(i, j))];
  }
};

using CgalDeformer =
    CGAL::Surface_mesh_deformation<SurfaceMesh, CGAL::Default, CGAL::Default, CGAL::ORIGINAL_ARAP, SameWeights>;

SurfaceMesh::Vertex_index at(std::int32_t vertex) {
  return SurfaceMesh::Vertex_index(static_cast<SurfaceMesh::size_type>(vertex));
}

SurfaceMesh surface_mesh(const Mesh& mesh) {
  SurfaceMesh out;
  for (const auto& v : mesh.vertices) out.add_vertex(Point(v.x(), v.y(), v.z()));
  for (const auto& f : mesh.faces) {
    if (out.add_face(at(f[0]), at(f[1]), at(f[2])) == SurfaceMesh::null_face()) rigless_bench::fail("not a manifold");
  }
  return out;
}

// CGAL, ready for its factorisation.
std::unique_ptr<CgalDeformer> cgal_deformer(SurfaceMesh& mesh, const rigless::Cells<double>& cells,
                                            const rigless_bench::Pull<float>& pull) {
  auto out = std::make_unique<CgalDeformer>(mesh, CGAL::get_initialized_vertex_index_map(mesh),
                                            CGAL::get_initialized_halfedge_index_map(mesh),
                                            get(CGAL::vertex_point, mesh), SameWeights{&cells});
  for (const auto v : mesh.vertices()) out->insert_roi_vertex(v);
  for (const auto& control : pull.controls) out->insert_control_vertex(at(control.vertex));
  return out;
}

std::vector<Eigen::Vector3d> positions(const SurfaceMesh& mesh) {
  std::vector<Eigen::Vector3d> out;
  for (const auto v : mesh.vertices()) out.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  return out;
}

void against_cgal(Bench& bench, const Mesh& mesh) {
  const auto pull = rigless_bench::pull<float>(mesh, 0.1f);
  const auto rest = mesh.rest<float>();
  Deformer<float> ours;
  const auto prepare = [&] {
    if (!ours.bind(rest, mesh.faces, {std::numeric_limits<float>::infinity(), {}}).ok() ||
        !ours.set_controls(pull.controls).ok()) {
      rigless_bench::fail("the deformer refused");
    }
  };
  prepare();
  const auto cells = rigless_bench::in_double(ours.cells());
  SurfaceMesh surface = surface_mesh(mesh);
  std::unique_ptr<CgalDeformer> cgal;
  const auto prepare_cgal = [&] {
    if (!cgal->preprocess()) rigless_bench::fail("CGAL refused");
  };

  // CGAL's turn leaves out its weights, its topology and its controls: preprocess() is ordering and factorisation.
  const bool large = mesh.vertices.size() > 20000;
  bench.compare(mesh.name,
                {{"bind and set_controls", prepare},
                 {"CGAL preprocess", prepare_cgal, [&] { cgal = cgal_deformer(surface, cells, pull); }}},
                large ? 5 : 9, large ? 1 : 3);

  // Both begin at rest with the controls already moved: CGAL's first solve is the deformer's first step.
  ours.set_targets(pull.targets);
  for (std::size_t c = 0; c < pull.controls.size(); ++c) {
    const auto& t = pull.targets[c];
    cgal->set_target_position(at(pull.controls[c].vertex), Point(static_cast<double>(t.x()), static_cast<double>(t.y()),
                                                                 static_cast<double>(t.z())));
  }
  ours.step(30);
  cgal->deform(30, 0);
  const detail::ElasticScale<double> elastic{std::numeric_limits<double>::infinity()};
  const double e = rigless::shape_energy<double>(cells, rigless_bench::in_double(ours.shape()), elastic);
  const double reference = rigless::shape_energy<double>(cells, positions(surface), elastic);
  const double apart = std::abs(e / reference - 1);
  bench.figure(mesh.name + ": energy after 30 iterations: off CGAL's", apart, "relative");
  if (!(apart < 1e-4)) rigless_bench::fail("not CGAL's energy");

  bench.compare(mesh.name, {{"iteration", [&] { ours.step(1); }}, {"CGAL iteration", [&] { cgal->deform(1, 0); }}},
                large ? 9 : 15);
}

}  // namespace

int main(int argc, char** argv) {
  Bench bench(argc, argv);
  const auto all = bench.small() ? rigless_bench::meshes({}, {24})
                                 : rigless_bench::meshes({"spot.obj", "cheburashka.off", "armadillo.obj"}, {54, 208});
  for (const Mesh& mesh : all) against_cgal(bench, mesh);
}
