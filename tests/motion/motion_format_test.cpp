#include "rigless/motion/detail/motion_format.h"

#include <doctest/doctest.h>

#include <string>

#include "sample_motions.h"

using namespace rigless;
using namespace rigless::detail;

TEST_CASE("formats are told by their first words") {
  CHECK(motion_format(small_bvh) == MotionFormat::bvh);
  CHECK(motion_format("\xEF\xBB\xBF"
                      "# note\r\n hierarchy\r\nROOT") == MotionFormat::bvh);
  CHECK(motion_format(small_asf) == MotionFormat::asf);
  CHECK(motion_format(small_amc) == MotionFormat::amc);
  CHECK(motion_format("1\nroot 0 0 0 0 0 0\n") == MotionFormat::amc);
  CHECK(motion_format(":radians\n1\n") == MotionFormat::amc);
  for (const char* text : {"", "\n", "1 2 3\n4 5 6", "solid x", "v 0 0 0", "{\"a\": 1}", "1", "\x89PNG"}) {
    CHECK(motion_format(text) == MotionFormat::unknown);
  }
}
