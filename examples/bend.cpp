#include <cstdio>
#include <vector>

#include "rigless/deform/deformer.h"

using Vec3 = rigless::Vec3<float>;

// A tower of square rings is bound once; its top is then pulled up and to the side.
int main() {
  std::vector<Vec3> vertices;
  std::vector<rigless::Face> faces;
  for (int y = 0; y <= 8; ++y) {
    for (int k = 0; k < 4; ++k) {
      vertices.push_back({k == 1 || k == 2 ? 0.2f : -0.2f, 0.2f * float(y), k < 2 ? 0.2f : -0.2f});
      if (y == 8) continue;
      const int a = 4 * y + k, b = 4 * y + (k + 1) % 4;
      faces.push_back({a, b, b + 4});
      faces.push_back({a, b + 4, a + 4});
    }
  }

  rigless::Deformer<float> deformer;
  const std::vector<rigless::Control<float>> controls = {{0, 0.6f}, {34, 0.6f}};  // the lowest and the highest ring
  if (!deformer.bind(vertices, faces).ok() || !deformer.set_controls(controls).ok()) return 1;

  const std::vector<Vec3> targets = {vertices[0], vertices[34] + Vec3(0.4f, 0.3f, 0.0f)};
  deformer.set_targets(targets);
  deformer.step(10);
  deformer.pose(1.0f);
  const Vec3 top = deformer.positions()[34];
  std::printf("the top went to %.2f %.2f %.2f\n", top.x(), top.y(), top.z());
  return (top - targets[1]).norm() < 1e-4f ? 0 : 1;
}
