// The solid inside a model: building it, and what it costs to take the model along.
#include "harness.h"
#include "meshes.h"
#include "rigless/mesh/solid.h"

namespace {

using rigless::Solid;
using rigless_bench::Bench;
using rigless_bench::Mesh;
using Vec3f = rigless::Vec3<float>;

// A twist about the vertical, half a turn over the height of the solid.
std::vector<Vec3f> twisted(const Solid<float>& solid) {
  const float height = rigless::detail::bounds<float>(solid.rest).height();
  std::vector<Vec3f> out;
  for (const Vec3f& p : solid.rest) {
    const float turn = 3.14159265f * p.y() / height, c = std::cos(turn), s = std::sin(turn);
    out.push_back({c * p.x() - s * p.z(), p.y(), s * p.x() + c * p.z()});
  }
  return out;
}

void measure(Bench& bench, const Mesh& mesh) {
  const auto vertices = mesh.rest<float>();
  const std::string name = mesh.name + " of " + std::to_string(mesh.faces.size()) + " triangles: ";
  Solid<float> solid;
  bench.run(
      name + "build a solid",
      [&] {
        if (!rigless::build_solid<float>(vertices, mesh.faces, {}, solid).ok()) rigless_bench::fail("no solid");
      },
      7);
  const std::vector<Vec3f> now = twisted(solid);
  std::vector<rigless::NodeTransform<float>> transforms(now.size());
  std::vector<Vec3f> out(vertices.size()), normals(vertices.size(), Vec3f(0, 1, 0));
  bench.run(name + "node transforms", [&] { rigless::node_transforms<float>(solid, now, transforms); });
  const double points = bench.run(
      name + "carry points", [&] { rigless::carry_points<float>(solid, vertices, transforms, out); }, 15);
  const double turned = bench.run(
      name + "carry normals", [&] { rigless::carry_normals<float>(solid, vertices, transforms, normals, out); }, 15);
  const double per_vertex = 1e6 / static_cast<double>(vertices.size());
  bench.figure(name + "carry points, for each vertex", points * per_vertex, "ns");
  bench.figure(name + "carry normals, for each vertex", turned * per_vertex, "ns");
  bench.run(
      name + "outermost vertices", [&] { rigless::outermost_vertices<float>(solid, vertices); }, 7);
  for (const Vec3f& p : out) {
    if (!p.allFinite()) rigless_bench::fail("not finite");
  }
}

}  // namespace

int main(int argc, char** argv) {
  Bench bench(argc, argv);
  std::vector<Mesh> all;
  if (!bench.small()) all = rigless_bench::meshes({"spot.obj", "armadillo.obj"}, {});
  for (const std::int32_t n : bench.small() ? std::vector{24} : std::vector{224, 708}) {
    all.push_back(rigless_bench::torus(n));
  }
  for (const Mesh& mesh : all) measure(bench, mesh);
}
