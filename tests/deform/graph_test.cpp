// A graph is solved as a surface is, and of a solid a control holds a ball or a slab.
#include <doctest/doctest.h>

#include "rigless/deform/deformer.h"
#include "rigless/deform/detail/solid_pieces.h"
#include "support/cylinder.h"
#include "support/voxels.h"

using namespace rigless;
using test::Cylinder;

TEST_CASE("the graph of a surface moves as the surface does, to the bit") {
  const Cylinder cylinder(16, 21);
  Deformer<double> surface, graph;
  REQUIRE(surface.bind(cylinder.vertices, cylinder.faces).ok());
  const auto& cells = surface.cells();
  REQUIRE(graph.bind_graph(cells.rest, cells.ring, cells.weight).ok());
  for (Deformer<double>* deformer : {&surface, &graph}) {
    REQUIRE(deformer->set_controls(cylinder.ends).ok());
    deformer->set_targets(cylinder.stretched(1.5));
    deformer->start();
    deformer->relax(20);
    deformer->pose(1.0);
  }
  for (std::size_t v = 0; v < cells.size(); ++v) CHECK(surface.positions()[v] == graph.positions()[v]);
}

TEST_CASE("a graph whose parts do not fit is refused and leaves the old binding") {
  const Cylinder cylinder(16, 21);
  Deformer<double> deformer;
  REQUIRE(deformer.bind(cylinder.vertices, cylinder.faces).ok());
  const auto cells = deformer.cells();
  std::vector<double> few(cells.weight.begin(), cells.weight.end() - 1);
  CHECK(deformer.bind_graph(cells.rest, cells.ring, few).error == Error::size_mismatch);
  auto broken = cells.rest;
  broken[7].x() = std::numeric_limits<double>::quiet_NaN();
  const Status status = deformer.bind_graph(broken, cells.ring, cells.weight);
  CHECK(status.error == Error::not_finite);
  CHECK(status.where == 7);
  CHECK(deformer.set_controls(cylinder.ends).ok());
}
