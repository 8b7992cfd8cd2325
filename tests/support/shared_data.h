// The reference data beside the project. A stranger's clone has none: tests that need it are then skipped, and counted
// so.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "support/json.h"

namespace rigless::test {

inline const char* const shared_dir = RIGLESS_SHARED_DIR "data/";

// TEST_CASE("..." * test::needs_shared())
inline doctest::skip needs_shared() {
  std::error_code unknown;
  return doctest::skip(!std::filesystem::exists(shared_dir, unknown));
}

// The whole file.
inline std::string shared_text(const std::string& path) {
  const std::string text = json::read_text(shared_dir + path);
  CAPTURE(path);
  REQUIRE_FALSE(text.empty());
  return text;
}

}  // namespace rigless::test
