// A hand's drag as the page asks for it, to be held against the same in WebAssembly (wasm_bench.mjs).
// --cases FOLDER writes what is dragged there instead, for the other side to read: as 32-bit numbers the counts V, F
// and C, V positions, F faces, C vertices, C radii, C targets; one file per mesh.
#include <cmath>
#include <fstream>

#include "harness.h"
#include "meshes.h"
#include "rigless/scene/body.h"

namespace {

using rigless_bench::Bench;
using rigless_bench::Mesh;

struct Case {
  std::string name;
  std::vector<rigless::Vec3<float>> rest, targets;
  std::vector<rigless::Face> faces;
  std::vector<rigless::Control<float>> controls;
};

Case make_case(const Mesh& mesh) {
  const auto pull = rigless_bench::pull<float>(mesh, 0.1f, 0.05f);
  return {mesh.name, mesh.rest<float>(), pull.targets, mesh.faces, pull.controls};
}

void write(const Case& drag, const std::string& folder) {
  std::ofstream out(folder + "/" + drag.name, std::ios::binary);
  const auto put = [&](const auto* data, std::size_t count) {
    out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(count * sizeof(*data)));
  };
  const std::int32_t counts[] = {static_cast<std::int32_t>(drag.rest.size()),
                                 static_cast<std::int32_t>(drag.faces.size()),
                                 static_cast<std::int32_t>(drag.controls.size())};
  put(counts, 3);
  put(drag.rest.data(), drag.rest.size());
  put(drag.faces.data(), drag.faces.size());
  for (const auto& control : drag.controls) put(&control.vertex, 1);
  for (const auto& control : drag.controls) put(&control.radius, 1);
  put(drag.targets.data(), drag.targets.size());
  if (!out) rigless_bench::fail("cannot write to " + folder);
}

void measure(Bench& bench, const Case& drag) {
  rigless::Body<float> body;
  if (!body.set_mesh(drag.rest, drag.faces).ok() || !body.set_controls(drag.controls).ok()) {
    rigless_bench::fail("the body refused");
  }
  const auto move = [&](bool restart) {
    if (!body.drag(drag.targets, 1.0f, restart).ok()) rigless_bench::fail("the drag failed");
  };
  bench.run(
      drag.name + ": drag from rest", [&] { move(true); }, 9);
  bench.run(
      drag.name + ": drag", [&] { move(false); }, 25);
}

}  // namespace

int main(int argc, char** argv) {
  Bench bench(argc, argv);
  std::string folder;
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], "--cases") == 0) folder = argv[i + 1];
  }
  const auto all =
      bench.small() ? rigless_bench::meshes({}, {24}) : rigless_bench::meshes({"spot.obj", "armadillo.obj"}, {54, 208});
  for (const Mesh& mesh : all) {
    const Case drag = make_case(mesh);
    if (folder.empty()) {
      measure(bench, drag);
    } else {
      write(drag, folder);
    }
  }
}
