// Any frame of a performance in the world: as vertices, or as the maps of the nodes that carry them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "rigless/retarget/detail/flight.h"
#include "rigless/scene/body.h"
#include "rigless/scene/performance.h"

namespace rigless {

// Deforms in the body-local frame, from rest, then puts back the yaw, adds the travel and sets the height: the lowest
// vertex of a supported frame lies on y = 0, where nothing stands as high as the human's feet are; a flight is a throw
// from where the body left the ground to where it lands, in the time that the human took. So a frame depends on nothing
// but the performance, whatever was made before it.
template <class S>
class Bake {
 public:
  struct Root {
    Vec3<S> position = Vec3<S>::Zero();
    S yaw = 0;
  };

  // `volume` is lambda_v. The body must have the performance's controls; both must outlive this. Allocates.
  void bind(Body<S>& body, const Performance<S>& performance, S volume) {
    RIGLESS_ASSERT(performance.control_count() == to_size(body.controls()));
    body_ = &body;
    performance_ = &performance;
    volume_ = volume;
    positions_.resize(to_size(body.vertices()));
    lowest_.assign(to_size(performance.frames), std::numeric_limits<S>::quiet_NaN());
  }

  // Makes a frame; see positions(), root(). The first frame of a flight that is asked for also deforms its two ends. No
  // allocation. Errors: index_out_of_range.
  Status frame(std::int32_t f) {
    if (performance_ == nullptr || f < 0 || f >= performance_->frames) return {Error::index_out_of_range, f};
    const Flight* flight = flight_over(f);
    S height = 0;
    if (flight != nullptr) height = height_in_flight(*flight, f);
    deform(f);
    const S grounded = -nth(lowest_, f);
    const auto& travel = nth(performance_->travel, f);
    height = flight != nullptr ? std::max(height, grounded) : grounded + travel[2];

    root_.position = {travel[0], height, travel[1]};
    root_.yaw = nth(performance_->yaw, f);
    return {};
  }

  // V, world: of the frame that was made last, for as long as the body was not moved since. No allocation.
  Span<const Vec3<S>> positions() {
    const Span<const Vec3<S>> local = body_->positions();
    const S c = std::cos(root_.yaw), s = std::sin(root_.yaw);
    for (std::size_t v = 0; v < local.size(); ++v) {
      const Vec3<S>& p = local[v];
      positions_[v] = Vec3<S>(c * p.x() + s * p.z(), p.y(), c * p.z() - s * p.x()) + root_.position;
    }
    return positions_;
  }

  // N, world: of the same frame, where a solid carries the vertices; see Body::maps(). No allocation.
  Span<const detail::NodeMap<S>> maps() {
    const S c = std::cos(root_.yaw), s = std::sin(root_.yaw);
    Mat3<S> turn;
    turn << c, S(0), s, S(0), S(1), S(0), -s, S(0), c;
    return body_->maps(turn, root_.position);
  }

  const Root& root() const { return root_; }

 private:
  const Flight* flight_over(std::int32_t f) const {
    for (const Flight& flight : performance_->flights) {
      if (flight.take_off < f && f < flight.landing) return &flight;
    }
    return nullptr;
  }

  void deform(std::int32_t f) {
    const std::size_t controls = performance_->control_count();
    const Span<const Vec3<S>> tracks = performance_->controls;
    const Span<const Vec3<S>> turns = performance_->turns;
    body_->act(tracks.subspan(to_size(f) * controls, controls), volume_,
               turns.empty() ? turns : turns.subspan(to_size(f) * controls, controls));
    nth(lowest_, f) = body_->lowest();
  }

  S lowest(std::int32_t f) {
    if (std::isnan(nth(lowest_, f))) deform(f);
    return nth(lowest_, f);
  }

  S supported_height(std::int32_t f) { return nth(performance_->travel, f)[2] - lowest(f); }

  // The height of the body's origin: a throw that lands exactly. The sum of flight_heights(), without its table.
  // Source: thesis Eq 3.31.
  S height_in_flight(const Flight& flight, std::int32_t f) {
    const S g = detail::gravity_per_frame(static_cast<S>(performance_fps));
    const S start = supported_height(flight.take_off);
    const S end = supported_height(flight.landing);
    const auto k = static_cast<S>(f - flight.take_off);
    return start + k * detail::flight_velocity(end - start, flight.landing - flight.take_off, g) + k * (k + 1) / 2 * g;
  }

  Body<S>* body_ = nullptr;
  const Performance<S>* performance_ = nullptr;
  S volume_ = 1;
  std::vector<Vec3<S>> positions_;  // V
  std::vector<S> lowest_;           // T: y of the lowest local vertex; NaN until it is known
  Root root_;
};

}  // namespace rigless
