#include "rigless/scene/detail/drag.h"

#include <doctest/doctest.h>

#include <cmath>

#include "support/alloc_count.h"
#include "support/cylinder.h"

using namespace rigless;
using namespace rigless::detail;
using test::Cylinder;

namespace {

// A cylinder held by a turning disc at each end, one of which a hand swings around.
template <class S>
struct Swing {
  Deformer<S> deformer;
  std::vector<Vec3<S>> targets;
  Drag<S> drag;

  Swing() {
    const Cylinder cylinder(24, 40);
    std::vector<Vec3<S>> rest;
    for (const auto& v : cylinder.vertices) rest.push_back(v.cast<S>());
    REQUIRE(deformer.bind(rest, cylinder.faces).ok());
    const auto low = static_cast<std::int32_t>(rest.size()) - 2, high = low + 1;
    REQUIRE(deformer.set_controls(std::vector<Control<S>>{{low, S(0.6)}, {high, S(0.6)}}).ok());
    targets = {rest[static_cast<std::size_t>(low)], rest[static_cast<std::size_t>(high)]};
    drag.bind(deformer);
  }

  std::vector<Vec3<S>> move(int frame) {
    std::vector<Vec3<S>> now = targets;
    now[1] += Vec3<S>(std::sin(S(0.2) * S(frame)), S(0.3) * std::cos(S(0.3) * S(frame)), S(0.1) * S(frame));
    drag.move(deformer, now, S(1), frame == 0);
    return {deformer.positions().begin(), deformer.positions().end()};
  }
};

}  // namespace

TEST_CASE_TEMPLATE("a drag goes on exactly where the last one stopped, whoever used the deformer meanwhile", S, float,
                   double) {
  Swing<S> alone, disturbed;
  for (int frame = 0; frame < 12; ++frame) {
    const auto expected = alone.move(frame);
    CHECK(disturbed.move(frame) == expected);
    disturbed.deformer.set_targets(std::vector<Vec3<S>>{{5, 0, 0}, {-3, 1, 2}});
    disturbed.deformer.start();
    disturbed.deformer.relax(3);
    disturbed.deformer.reset();
  }
}

TEST_CASE("two drags continue the iteration: as four steps without a break") {
  Swing<double> swing;
  swing.move(0);
  ShapeState<double> begun;
  swing.deformer.keep(begun);
  swing.move(1);
  const auto dragged = swing.move(1);
  swing.deformer.resume(begun);
  swing.deformer.step(2 * iterations_per_drag);
  swing.deformer.pose(1.0);
  const auto positions = swing.deformer.positions();
  CHECK(std::equal(positions.begin(), positions.end(), dragged.begin()));
}

TEST_CASE("drags do not allocate") {
  Swing<float> swing;
  std::vector<Vec3<float>> targets = swing.targets;
  swing.drag.move(swing.deformer, targets, 1.0f, true);
  targets[1].x() += 0.3f;
  const auto before = test::allocation_count;
  swing.drag.move(swing.deformer, targets, 1.0f, false);
  swing.drag.move(swing.deformer, targets, 1.0f, true);
  CHECK(test::allocation_count == before);
}
