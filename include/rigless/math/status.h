// What went wrong, and where. The core has two kinds of error only: bad data returns a Status, bad code (a broken
// precondition) trips RIGLESS_ASSERT.
#pragma once

#include <cstdint>

namespace rigless {

enum class Error : std::int32_t {
  none = 0,
  // text and files
  empty_input,      // nothing but white space
  not_this_format,  // the header of another format, or binary data
  unexpected_end,   // the text stops inside an element; where: line
  bad_number,       // a number was expected, or it is not finite; where: line
  bad_syntax,       // a keyword or brace was expected; where: line
  unknown_joint,    // a joint or bone that was never declared; where: line
  duplicate_joint,  // a joint name is declared twice; where: line
  unsupported,      // valid, but nothing this library can use; where: line
  no_frames,        // a motion without a single whole frame
  // meshes
  no_faces,            // nothing to deform
  index_out_of_range,  // where: face, control or joint with the bad index
  not_finite,          // NaN or infinity; where: vertex, frame or row
  // solvers
  no_controls,           // nothing holds the surface, or a shell of it; where: a vertex of that shell
  factorization_failed,  // the matrix is singular or indefinite; where: row if known
  size_mismatch,         // two arrays that belong together differ in length
  no_examples,           // nothing to learn from
  bad_constraint,        // a track or frame that does not exist, a velocity at frame 0, not finite; where: constraint
  infeasible,            // hard constraints contradict each other; where: constraint
  out_of_memory
};

// 8 bytes. `where` is the offending row, line (from 1), vertex, face or frame (from 0); -1 when there is none.
struct [[nodiscard]] Status {
  Error error = Error::none;
  std::int32_t where = -1;

  constexpr Status() = default;
  template <class I>
  constexpr Status(Error what, I at) : error(what), where(static_cast<std::int32_t>(at)) {}

  constexpr bool ok() const { return error == Error::none; }
};

}  // namespace rigless
