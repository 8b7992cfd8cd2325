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
  std::string a, b, c;  // "12" or "12/3/4"
  for (std::string kind; model >> kind;) {
    if (kind == "v" && model >> p.x() >> p.y() >> p.z()) vertices.push_back(p);
    if (kind == "f" && model >> a >> b >> c) faces.push_back({std::stoi(a) - 1, std::stoi(b) - 1, std::stoi(c) - 1});
  }

  rigless::RetargetMeshInput<float> input = {text, {}, vertices, faces, {}, {}};
  rigless::RetargetedMesh<float> dancer;
  const rigless::Status status = rigless::retarget_mesh(input, {}, dancer);
  if (!status.ok()) return std::fprintf(stderr, "error %d at %d\n", int(status.error), status.where), 1;
  for (const auto& point : dancer.points()) std::printf("vertex %d follows %s\n", point.vertex, point.joint.c_str());
  for (int frame = 0; frame < dancer.frames(); ++frame) {
    if (!dancer.frame(frame, vertices).ok()) return 1;
    std::printf("%4.2f s: the first vertex is at %.2f %.2f %.2f\n", frame / dancer.fps, double(vertices[0].x()),
                double(vertices[0].y()), double(vertices[0].z()));
  }
}
