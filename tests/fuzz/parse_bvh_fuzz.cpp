// Anything at all is a BVH file or an error. Not one of the tests; .github/workflows/ci.yml builds it and runs it for a
// minute.
#include "rigless/motion/parse_bvh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rigless::Clip<float> clip;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const rigless::Status status = rigless::parse_bvh(text, clip);
  if (status.ok() && clip.frames < 1) __builtin_trap();
  return 0;
}
