// Bodies without a human's limbs: what they are held by.
#include <doctest/doctest.h>

#include "rigless/mesh/shape_analysis.h"
#include "support/voxels.h"

using namespace rigless;

namespace {

struct Found {
  BlockBody<float> body;
  ShapeAnalysis<float> shape;

  std::vector<Vec3<float>> all(BodyRole role) const {
    std::vector<Vec3<float>> places;
    for (const BodyPoint<float>& p : shape.points)
      if (p.wanted && p.role == role) places.push_back(body.vertices[static_cast<std::size_t>(p.vertex)]);
    return places;
  }
};

Found find(const std::vector<Block>& blocks, const std::vector<Landmark<float>>& named = {}) {
  Found found;
  found.body = build_blocks<float>(blocks);
  const Posture<float> stands;
  REQUIRE(
      analyse_shape<float>(found.body.vertices, found.body.faces, found.shape, &stands, FileAxes::y_up, named).ok());
  return found;
}

void check_pair(const std::vector<Vec3<float>>& places, float least_aside) {
  REQUIRE(places.size() == 2);
  CHECK(places[0].x() * places[1].x() < 0);
  for (const Vec3<float>& p : places) CHECK(std::abs(p.x()) >= least_aside);
}

}  // namespace

TEST_CASE("a fish has fins for hands, no feet, its head before its dorsal fin, and a tail") {
  const Found fish = find({{{-4, 3, -6}, {4, 15, 16}},  // trunk
                           {{-3, 5, 16}, {3, 11, 20}},  // snout
                           {{-1, 15, 0}, {1, 26, 6}},   // dorsal fin
                           {{-14, 0, 2}, {-4, 4, 7}},   // side fins, the lowest of all
                           {{4, 0, 2}, {14, 4, 7}},
                           {{-2, 6, -16}, {2, 12, -6}},     // stalk of the tail
                           {{-1, 0, -22}, {1, 18, -16}}});  // its fin
  check_pair(fish.all(BodyRole::hand), 12);
  CHECK(fish.all(BodyRole::foot).empty());
  CHECK(fish.all(BodyRole::foreleg).empty());
  REQUIRE(fish.all(BodyRole::head).size() == 1);
  CHECK(fish.all(BodyRole::head)[0].z() > 12);
  REQUIRE(fish.all(BodyRole::tail).size() == 1);
  CHECK(fish.all(BodyRole::tail)[0].z() < -12);
  REQUIRE(fish.all(BodyRole::hips).size() == 1);
  REQUIRE(fish.all(BodyRole::chest).size() == 1);
  CHECK(fish.all(BodyRole::hips)[0].z() < fish.all(BodyRole::chest)[0].z() - 5);
}

TEST_CASE("a snake whose tail is named stands on no feet, coiled or not") {
  const std::vector<Block> coiled = {{{-2, 0, -14}, {2, 4, 4}}, {{-2, 0, 0}, {2, 22, 4}}, {{-3, 20, -1}, {3, 26, 9}}};
  const Found snake = find(
      coiled, {{{0, 21, 2}, BodyRole::head, 0}, {{0, 2, -4}, BodyRole::tail, 0}, {{0, 2, -12}, BodyRole::tail, 0}});
  CHECK(snake.all(BodyRole::foot).empty());
  CHECK(snake.all(BodyRole::hand).empty());
  REQUIRE(snake.all(BodyRole::tail).size() == 1);
  CHECK(snake.all(BodyRole::tail)[0].z() < -10);
  CHECK(snake.all(BodyRole::head)[0].y() > 20);
}

TEST_CASE("a crab's claws are hands beside its legs") {
  std::vector<Block> crab = {{{-10, 6, -7}, {10, 11, 7}},
                             {{-9, 7, 7}, {-6, 10, 16}},
                             {{6, 7, 7}, {9, 10, 16}},
                             {{-10, 6, 16}, {-5, 11, 22}},
                             {{5, 6, 16}, {10, 11, 22}}};
  for (const int z : {-6, -1, 4}) {
    crab.push_back({{-18, 6, z}, {-10, 8, z + 2}});
    crab.push_back({{10, 6, z}, {18, 8, z + 2}});
    crab.push_back({{-18, 0, z}, {-16, 8, z + 2}});
    crab.push_back({{16, 0, z}, {18, 8, z + 2}});
  }
  const Found found = find(crab);
  check_pair(found.all(BodyRole::hand), 5);
  for (const Vec3<float>& claw : found.all(BodyRole::hand)) CHECK(claw.z() > 18);
  CHECK(found.all(BodyRole::foot).size() + found.all(BodyRole::foreleg).size() == 6);
}

TEST_CASE("a tail held over a body is neither its head nor its back, and forelegs side by side are two") {
  const Found cat = find({{{-4, 10, -12}, {4, 18, 8}},  // trunk
                          {{-3, 0, -12}, {-1, 10, -9}},
                          {{1, 0, -12}, {3, 10, -9}},  // hind legs
                          {{-2, 0, 8}, {2, 3, 20}},
                          {{-2, 0, 5}, {2, 12, 8}},    // forelegs, as one
                          {{-3, 11, 8}, {3, 18, 16}},  // head
                          {{-1, 16, -16}, {1, 18, -12}},
                          {{-1, 16, -18}, {1, 40, -16}}});  // tail
  CHECK(cat.all(BodyRole::head)[0].z() > 5);
  check_pair(cat.all(BodyRole::foreleg), 1);
  check_pair(cat.all(BodyRole::foot), 1);
  REQUIRE(cat.all(BodyRole::hips).size() == 1);
  CHECK(cat.all(BodyRole::hips)[0].y() < 20);
}

TEST_CASE("a wing whose only joint is at its base ends at its tip") {
  const std::vector<Block> wasp = {{{-3, 0, -3}, {3, 26, 3}},  {{-3, 26, -4}, {3, 32, 5}}, {{-26, 22, -1}, {-3, 23, 3}},
                                   {{3, 22, -1}, {26, 23, 3}}, {{-5, 10, 3}, {-4, 11, 9}}, {{4, 10, 3}, {5, 11, 9}}};
  const Found found = find(wasp, {{{-3, 22, 1}, BodyRole::hand, -1}, {{3, 22, 1}, BodyRole::hand, 1}});
  check_pair(found.all(BodyRole::hand), 22);
}
