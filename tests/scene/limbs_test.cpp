// Limbs of a solid: where they leave the trunk, and that they turn as a whole.
#include <doctest/doctest.h>

#include "rigless/scene/body.h"
#include "support/alloc_count.h"
#include "support/voxels.h"

using namespace rigless;

namespace {

using Vec3f = Vec3<float>;

// Arms level, as wide as the body is high; sleeves to the elbow.
std::vector<Block> sleeved_blocks() {
  std::vector<Block> blocks = block_human;
  blocks.push_back({{4, 26, -2}, {9, 31, 3}});
  blocks.push_back({{-9, 26, -2}, {-4, 31, 3}});
  return blocks;
}
BlockBody<float> sleeved_human() { return build_blocks<float>(sleeved_blocks()); }

struct HeldHuman {
  enum : std::int32_t { hips, chest, left_hand, right_hand };

  BlockBody<float> model;
  Body<float> body;
  std::vector<Control<float>> controls;
  std::vector<Vec3f> rest;

  explicit HeldHuman(BlockBody<float> of) : model(std::move(of)) {
    REQUIRE(body.set_mesh(model.vertices, model.faces, Solve::solid).ok());
    hold({0, 18, 2}, 2, true);
    hold({0, 28, 2}, 2, true);
    hold({16, 28, 0}, 1.5f, false);
    hold({-16, 28, 0}, 1.5f, false);
    hold({2, 0, 0}, 1.5f, false);
    hold({-2, 0, 0}, 1.5f, false);
    REQUIRE(body.set_controls(controls).ok());
    rest.assign(body.rest_controls().begin(), body.rest_controls().end());
  }

  void hold(const Vec3f& near, float radius, bool slab) {
    std::size_t nearest = 0;
    for (std::size_t v = 1; v < model.vertices.size(); ++v)
      if ((model.vertices[v] - near).squaredNorm() < (model.vertices[nearest] - near).squaredNorm()) nearest = v;
    controls.push_back({static_cast<std::int32_t>(nearest), radius, slab});
  }

  // How long the edges of the middle of the arm are of how long they rest, least and most.
  std::pair<float, float> stretch_of_left_arm() {
    const Span<const Vec3f> now = body.positions();
    std::pair<float, float> range = {1e9f, 0};
    for (const Face& f : model.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t a = f[k], b = f[(k + 1) % 3];
        const Vec3f &p = nth(model.vertices, a), &q = nth(model.vertices, b);
        if (std::min(p.x(), q.x()) < 9 || std::max(p.x(), q.x()) > 14) continue;
        const float ratio = (nth(now, a) - nth(now, b)).norm() / (p - q).norm();
        range = {std::min(range.first, ratio), std::max(range.second, ratio)};
      }
    }
    return range;
  }

  // The middle of what rests in a box.
  Vec3f middle_of(const Vec3f& low, const Vec3f& high) {
    Vec3f sum = Vec3f::Zero();
    float count = 0;
    for (std::size_t v = 0; v < model.vertices.size(); ++v) {
      const Vec3f& p = model.vertices[v];
      if ((p - low).minCoeff() < 0 || (high - p).minCoeff() < 0) continue;
      sum += body.positions()[v];
      ++count;
    }
    return sum / count;
  }
  // Of what rests between two planes across the left arm.
  Vec3f middle_of_left_arm(float from, float to) { return middle_of({from, 0, -99}, {to, 99, 99}); }
};

}  // namespace

TEST_CASE("a limb leaves where the trunk ends, whatever sleeves it wears") {
  for (HeldHuman held : {HeldHuman(build_blocks<float>(block_human)), HeldHuman(sleeved_human())}) {
    for (const std::int32_t hand : {HeldHuman::left_hand, HeldHuman::right_hand}) {
      const detail::Limb<float>& limb = held.body.limbs()[static_cast<std::size_t>(hand)];
      CHECK(std::abs(limb.base.x()) > 3);
      CHECK(std::abs(limb.base.x()) < 6.5f);
      CHECK(limb.length > 9);
      CHECK(limb.length < 13.5f);
      CHECK(std::abs(limb.middle.x()) > 8.5f);
      CHECK(std::abs(limb.middle.x()) < 12.5f);
    }
    CHECK(held.body.limbs()[HeldHuman::chest].length == 0);
  }
}

TEST_CASE("a slab of the chest leaves the arms beside it alone") {
  const HeldHuman held(build_blocks<float>(block_human));
  const Discs<float>& discs = held.body.deformer().discs();
  const Solid<float>& solid = held.body.solid();
  int of_chest = 0;
  for (std::size_t v = 0; v < solid.rest.size(); ++v) {
    if (discs.owner[v] != HeldHuman::chest) continue;
    ++of_chest;
    CHECK(std::abs(solid.rest[v].x()) < 8);
  }
  CHECK(of_chest > 50);
}

TEST_CASE("an arm that rests level hangs, or is thrown up, as long as it is") {
  HeldHuman held(build_blocks<float>(block_human));
  for (const float up : {-1.0f, 1.0f}) {
    std::vector<Vec3f> targets = held.rest;
    targets[HeldHuman::left_hand] = Vec3f(6, 28 + 10 * up, 0);
    held.body.act(targets, 1);
    const auto [least, most] = held.stretch_of_left_arm();
    CHECK(least > 0.75f);
    CHECK(most < 1.4f);
    const Vec3f elbow = held.middle_of_left_arm(9, 12);
    CHECK(std::abs(elbow.x() - 6) < 1.8f);
    CHECK(up * (elbow.y() - 28) > 3);
  }
}

TEST_CASE("an arm bends backwards at the elbow when its hand is nearer than it is long") {
  HeldHuman held(build_blocks<float>(block_human));
  std::vector<Vec3f> targets = held.rest;
  targets[HeldHuman::left_hand] = Vec3f(6, 21, 1);
  held.body.act(targets, 1);
  const auto [least, most] = held.stretch_of_left_arm();
  CHECK(least > 0.6f);
  CHECK(most < 1.5f);
  CHECK(held.middle_of_left_arm(9, 12).z() < -0.4f);
}

TEST_CASE("a straight leg bends forwards, also where its foot points forward") {
  HeldHuman held(build_blocks<float>(block_human));
  constexpr std::size_t left = 4;
  held.controls.resize(left);
  held.hold({2, 0, 5}, 1.5f, false);
  held.hold({-2, 0, 5}, 1.5f, false);
  REQUIRE(held.body.set_controls(held.controls).ok());
  std::vector<Vec3f> targets(held.body.rest_controls().begin(), held.body.rest_controls().end());
  const Vec3f low(0.5f, 7, -9), high(9, 10, 9);
  const auto knee = [&] {
    held.body.act(targets, 1);
    return held.middle_of(low, high);
  };
  const Vec3f rest = knee();
  targets[left] += Vec3f(0, 4, 0);
  CHECK(knee().z() > rest.z() + 1);
}

TEST_CASE("a hand that is to go into a large head passes beside it; elsewhere it goes where it is asked") {
  std::vector<Block> blocks = block_human;
  blocks.push_back({{-8, 32, -6}, {8, 44, 7}});
  HeldHuman held(build_blocks<float>(blocks));
  const auto deepest = [&] {
    float depth = 0;
    for (std::size_t v = 0; v < held.model.vertices.size(); ++v) {
      if (held.model.vertices[v].x() < 14) continue;
      const Vec3f p = held.body.positions()[v];
      const Vec3f in(8 - std::abs(p.x()), std::min(p.y() - 32, 44 - p.y()), std::min(p.z() + 6, 7 - p.z()));
      depth = std::max(depth, in.minCoeff());
    }
    return depth;
  };
  std::vector<Vec3f> targets = held.rest;
  for (const Vec3f& asked : {Vec3f(3, 37, 0), Vec3f(6, 36, 4), Vec3f(0, 36, 2)}) {
    targets[HeldHuman::left_hand] = asked;
    held.body.act(targets, 1);
    CHECK(deepest() < 1);
  }
  const auto hand = [&] { return held.body.positions()[static_cast<std::size_t>(held.controls[2].vertex)]; };
  for (const Vec3f& asked : {Vec3f(12, 36, 0), Vec3f(7, 20, 8), held.rest[HeldHuman::left_hand]}) {
    targets[HeldHuman::left_hand] = asked;
    held.body.act(targets, 1);
    CHECK((hand() - asked).norm() < 0.5f);
  }
}

TEST_CASE("a limb that is known leaves where it is said to, and turns there") {
  HeldHuman held(build_blocks<float>(sleeved_blocks()));
  Control<float>& hand = held.controls[HeldHuman::left_hand];
  hand.on_limb = true;
  hand.base = Vec3f(6, 28.5f, 0.5f);
  hand.bend = Vec3f(12, 28.5f, 0.5f);
  REQUIRE(held.body.set_controls(held.controls).ok());
  const detail::Limb<float>& limb = held.body.limbs()[HeldHuman::left_hand];
  CHECK((limb.base - hand.base).norm() < 1e-6f);
  CHECK((limb.middle - hand.bend).norm() < 1e-6f);
  CHECK(limb.length > 9.9f);
  CHECK(limb.length < 10.4f);
  std::vector<Vec3f> targets = held.rest;
  targets[HeldHuman::left_hand] = Vec3f(6, 18.5f, 0.5f);
  held.body.act(targets, 1);
  CHECK(held.middle_of_left_arm(11, 13).y() < 25);
}

TEST_CASE("hands that are mirror images have arms that are") {
  std::vector<Block> blocks = block_human;
  blocks.push_back({{4, 22, -4}, {11, 33, 5}});  // a left sleeve like a bell
  const HeldHuman held(build_blocks<float>(blocks));
  const detail::Limb<float>&left = held.body.limbs()[HeldHuman::left_hand],
        &right = held.body.limbs()[HeldHuman::right_hand];
  CHECK(left.length == right.length);
  CHECK(std::abs(left.base.x() + right.base.x()) < 0.1f);
  CHECK(left.base.y() == right.base.y());
}

TEST_CASE("limbs that turn do not allocate") {
  HeldHuman held(build_blocks<float>(block_human));
  std::vector<Vec3f> targets = held.rest;
  targets[HeldHuman::left_hand] = Vec3f(6, 18, 0);
  held.body.act(targets, 1);
  const auto before = test::allocation_count;
  held.body.act(targets, 1);
  CHECK(test::allocation_count == before);
}

TEST_CASE("a foot on the ground lies flat while its knee bends, a lifted one turns with its leg") {
  HeldHuman held(build_blocks<float>(block_human));
  constexpr std::size_t left = 4, right = 5;
  const auto lean = [&](std::size_t foot) {  // of its sole, radians
    const Mat3<float>& turn = held.body.deformer().disc_rotations()[foot];
    return std::acos(std::min(turn(1, 1), 1.0f));
  };
  std::vector<Vec3f> targets = held.rest;
  for (const std::size_t foot : {left, right}) targets[foot] += Vec3f(0, 5, 3);
  held.body.act(targets, 1);
  CHECK(lean(left) < 1e-3f);
  CHECK(lean(right) < 1e-3f);
  targets[right] = held.rest[right];
  held.body.act(targets, 1);
  CHECK(lean(left) > 0.2f);
  CHECK(lean(right) < 1e-3f);
  const auto before = test::allocation_count;
  REQUIRE(held.body.drag(targets, 1, false).ok());
  CHECK(test::allocation_count == before);
  CHECK(lean(left) > 0.2f);
}

TEST_CASE("a thick arm swings as a thin one does, a bump half as far") {
  const auto swing = [](int out, int thick) {
    std::vector<Block> blocks(block_human.begin(), block_human.begin() + 5);  // without arms, neck and head
    for (const int side : {-1, 1}) {
      const int from = 4 * side, to = out * side;
      blocks.push_back({{std::min(from, to), 30 - thick, -thick / 2}, {std::max(from, to), 30, thick - thick / 2}});
    }
    const HeldHuman held(build_blocks<float>(blocks));
    return held.body.swing(held.body.limbs()[HeldHuman::left_hand]);
  };
  CHECK(swing(16, 3) == 1);
  CHECK(swing(17, 5) > 0.9);
  CHECK(swing(9, 9) < 0.6);
}

TEST_CASE("a hand that is twisted turns by that much, takes its arm along and leaves no trace") {
  HeldHuman held(build_blocks<float>(block_human));
  held.body.act(held.rest, 1);
  const std::vector<Vec3f> before(held.body.positions().begin(), held.body.positions().end());
  std::vector<Vec3f> turns(held.rest.size(), Vec3f::Zero());
  turns[HeldHuman::left_hand] = {0.9f, 0, 0};  // about the arm
  held.body.act(held.rest, 1, turns);
  const std::vector<Vec3f> twisted(held.body.positions().begin(), held.body.positions().end());
  // by how much what rests between two planes across the arm is turned about it
  const auto turn_between = [&](float from, float to) {
    const Vec3f center = held.rest[HeldHuman::left_hand];
    float sine = 0, cosine = 0;
    for (std::size_t v = 0; v < before.size(); ++v) {
      const Vec3f p = before[v] - center, q = twisted[v] - center;
      if (held.model.vertices[v].x() < from || held.model.vertices[v].x() > to) continue;
      sine += p.y() * q.z() - p.z() * q.y();
      cosine += p.y() * q.y() + p.z() * q.z();
    }
    return std::atan2(sine, cosine);
  };
  CHECK(turn_between(15, 99) == doctest::Approx(0.9).epsilon(0.05));
  CHECK(turn_between(8, 11) > 0.1f);
  CHECK(turn_between(8, 11) < turn_between(15, 99) - 0.1f);
  const std::int64_t allocated = test::allocation_count;
  held.body.act(held.rest, 1, turns);
  CHECK(test::allocation_count == allocated);
  held.body.act(held.rest, 1);
  for (std::size_t v = 0; v < before.size(); ++v) REQUIRE(held.body.positions()[v] == before[v]);
}
