#include <cstdio>
#include <fstream>
#include <iterator>

#include "rigless/retarget_mesh.h"

// retarget model.obj motion.bvh: a model of triangles acts out a motion. Where to hold it is guessed from its shape.
int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ifstream model(argv[1]), motion(argv[2]);
  const std::string text(std::istreambuf_iterator<char>(motion), {});
  std::vector<rigless::Vec3<float>> vertices;
  std::vector<rigless::Face> faces;
  rigless::Vec3<float> p;
  rigless::Face f;
  for (std::string kind; model >> kind;) {
    if (kind == "v" && model >> p.x() >> p.y() >> p.z()) vertices.push_back(p);
    if (kind == "f" && model >> f[0] >> f[1] >> f[2]) faces.push_back({f[0] - 1, f[1] - 1, f[2] - 1});
  }

  rigless::RetargetMeshInput<float> input = {text, {}, vertices, faces, {}, {}};
  rigless::RetargetedMesh<float> dancer;
  if (!rigless::retarget_mesh(input, {}, dancer).ok()) return 1;
  for (const auto& point : dancer.points()) std::printf("vertex %d follows %s\n", point.vertex, point.joint.c_str());
  for (int frame = 0; frame < dancer.frames(); ++frame) {
    if (!dancer.frame(frame, vertices).ok()) return 1;
    std::printf("%4.2f s: the first vertex is at %.2f %.2f %.2f\n", frame / dancer.fps, double(vertices[0].x()),
                double(vertices[0].y()), double(vertices[0].z()));
  }
}
