// Small motion files written for the tests, and the real ones that may be absent.
#pragma once

#include <string>
#include <string_view>

#include "support/shared_data.h"

namespace rigless {

// Four joints, 1 + 3 + 1 channels in unlike orders, two frames.
inline constexpr std::string_view small_bvh =
    "HIERARCHY\n"
    "ROOT Hips\n"
    "{\n"
    "  OFFSET 0 0 0\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n"
    "  JOINT Knee\n"
    "  {\n"
    "    OFFSET 1 0 0\n"
    "    CHANNELS 1 Zrotation\n"
    "    End Site\n"
    "    {\n"
    "      OFFSET 0 2 0\n"
    "    }\n"
    "  }\n"
    "  JOINT Tail\n"
    "  {\n"
    "    OFFSET 0 0 3\n"
    "  }\n"
    "}\n"
    "MOTION\n"
    "Frames: 2\n"
    "Frame Time: 0.04\n"
    "0 0 0 0 0 0 0\n"
    "10 20 30 90 0 0 90\n";

inline constexpr std::string_view small_asf =
    "# a comment\n"
    ":version 1.10\n"
    ":name small\n"
    ":units\n"
    "  mass 1.0\n"
    "  length 0.45\n"
    "  angle deg\n"
    ":documentation\n"
    "  begin of nothing\n"
    ":root\n"
    "  order TX TY TZ RX RY RZ\n"
    "  axis XYZ\n"
    "  position 0 0 0\n"
    "  orientation 0 0 0\n"
    ":bonedata\n"
    "  begin\n"
    "    id 1\n"
    "    name thigh\n"
    "    direction 0 -1 0\n"
    "    length 8\n"
    "    axis 0 0 90 XYZ\n"
    "    dof rx rz\n"
    "    limits (-160.0 20.0)\n"
    "           (-70.0 70.0)\n"
    "  end\n"
    "  begin\n"
    "    id 2\n"
    "    name shin\n"
    "    direction 0 -2 0\n"
    "    length 4\n"
    "    axis 0 0 0 XYZ\n"
    "  end\n"
    ":hierarchy\n"
    "  begin\n"
    "    root thigh\n"
    "    thigh shin\n"
    "  end\n";

inline constexpr std::string_view small_amc =
    "#!OML:ASF small.asf\n"
    ":FULLY-SPECIFIED\n"
    ":DEGREES\n"
    "1\n"
    "root 0 9 0 0 0 0\n"
    "thigh 0 0\n"
    "2\n"
    "root 1 9 0 0 90 0\n"
    "thigh 90 0\n";

// Text with every `from` replaced.
inline std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string out(text);
  for (std::size_t at = 0; (at = out.find(from, at)) != std::string::npos; at += to.size()) {
    out.replace(at, from.size(), to);
  }
  return out;
}

// A file of the shared data, for tests that are marked needs_shared().
inline std::string shared_motion(const std::string& name) { return test::shared_text("motions/" + name); }

}  // namespace rigless
