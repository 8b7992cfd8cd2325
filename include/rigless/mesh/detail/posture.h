// Which way a model stands and looks, guessed from its shape.
#pragma once

#include "rigless/mesh/detail/symmetry.h"

namespace rigless::detail {

// A posture, and how much speaks for it against the next best: about 1 where there is no doubt, 0 where there is none
// better than another.
template <class S>
struct PostureGuess {
  Posture<S> posture;
  S sure = 0;
};

// What speaks for an axis being up before the body is looked at, and how much must speak for a body that looks
// backwards.
template <class S>
S usual_up(FileAxes file, const Vec3<S>& up) {
  const bool y = up.y() > S(0.5), z = up.z() > S(0.5);
  if (file == FileAxes::y_up_by_rule) return y ? S(6) : S(0);
  if (file == FileAxes::y_up) return y ? S(2.4) : z ? S(0.6) : S(0);
  if (file == FileAxes::z_up) return z ? S(1.6) : y ? S(1) : S(0);
  return y ? S(1) : z ? S(0.6) : S(0);
}

template <class S>
S usual_front(FileAxes file) {
  return file == FileAxes::y_up_by_rule ? S(0.32) : file == FileAxes::unknown ? S(0.01) : S(0.08);
}

// Axis k of 0 .. 5: +x, -x, +y, -y, +z, -z.
template <class S>
Vec3<S> signed_axis(int k) {
  return (k % 2 == 0 ? S(1) : S(-1)) * Vec3<S>::Unit(k / 2);
}

template <class S>
Vec3<S> mean_of(Span<const Vec3<S>> samples) {
  Vec3<S> mean = Vec3<S>::Zero();
  for (const Vec3<S>& p : samples) mean += p / static_cast<S>(samples.size());
  return mean;
}

// Whether nothing but air is in the middle, some way up: legs, and not the two ends of a fin.
template <class S>
bool stands_astride(Span<const Vec3<S>> samples, const SymmetryPlane<S>& plane, const Vec3<S>& up, S to) {
  if (!(plane.misfit < S(0.035)) || std::abs(plane.normal.dot(up)) > S(0.3)) return false;
  S widest = 0, middle = 0, all = 0;
  for (const Vec3<S>& p : samples)
    if (up.dot(p) < to) widest = std::max(widest, std::abs(plane.side(p)));
  for (const Vec3<S>& p : samples) {
    if (!(up.dot(p) < to)) continue;
    all += S(1);
    if (std::abs(plane.side(p)) < S(0.12) * widest) middle += S(1);
  }
  return middle < S(0.01) * all;
}

// What speaks for an axis being up: the weight of a body is over what it stands on, which is mostly two tips or four,
// and a narrow body is upright, surely so on two legs.
template <class S>
S uprightness(Span<const Vec3<S>> samples, Span<const Vec3<S>> tips, const SymmetryPlane<S>& plane, const Vec3<S>& up) {
  const Bounds<S> box = bounds(samples);
  const S tall = std::abs(up.dot(box.extent())), low = std::min(up.dot(box.low), up.dot(box.high));
  Bounds<S> base{box.high, box.low};
  for (const Vec3<S>& p : samples) {
    if (up.dot(p) - low > S(0.04) * tall) continue;
    base.low = base.low.cwiseMin(p);
    base.high = base.high.cwiseMax(p);
  }
  const Vec3<S> mean = mean_of(samples), off = (mean - (base.low + base.high) / S(2)).cwiseAbs();
  const Vec3<S> room = (base.high - base.low) / S(2) + (S(1) * box.diagonal()) * up.cwiseAbs();
  int standing = 0;
  for (const Vec3<S>& p : tips) standing += up.dot(p) - low < S(0.1) * tall ? 1 : 0;
  S wide = 0, deep = std::numeric_limits<S>::max();
  for (int k = 0; k < 3; ++k) {
    if (std::abs(up[k]) > S(0.5)) continue;
    wide = std::max(wide, box.extent()[k]);
    deep = std::min(deep, box.extent()[k]);
  }
  S score = 0;
  const bool astride =
      tall > S(0.85) * wide && tall > S(1.2) * deep && stands_astride(samples, plane, up, low + S(0.3) * tall);
  if ((off.array() <= room.array()).all()) score += standing >= 4 ? S(2.5) : standing >= 2 || astride ? S(2) : S(1);
  score += astride ? S(2) : S(0);
  score += tall > S(1.05) * wide ? S(0.7) : tall < S(0.95) * deep ? S(-0.5) : S(0);
  return score;
}

// Whether the top quarter is a tail held high: a small part of the body, and thin above `from` of the height.
template <class S>
bool ends_thin(Span<const Vec3<S>> samples, const Vec3<S>& up, S from) {
  constexpr std::size_t slices = 8;
  const Bounds<S> box = bounds(samples);
  const S tall = std::abs(up.dot(box.extent())), low = std::min(up.dot(box.low), up.dot(box.high));
  std::array<Vec3<S>, slices> sum;
  sum.fill(Vec3<S>::Zero());
  std::array<S, slices> squares{}, count{};
  S quarter = 0, all = 0, spread = 0;
  for (const Vec3<S>& p : samples) {
    const S h = (up.dot(p) - low) / tall;
    if (h > S(0.75)) quarter += S(1);
    if (!(h > from)) continue;
    const std::size_t k = std::min(slices - 1, static_cast<std::size_t>((h - from) / (S(1) - from) * S(slices)));
    const Vec3<S> flat = p - up.dot(p) * up;
    sum[k] += flat;
    squares[k] += flat.squaredNorm();
    count[k] += S(1);
    all += S(1);
  }
  for (std::size_t k = 0; k < slices; ++k)
    if (count[k] > S(0)) spread += squares[k] - sum[k].squaredNorm() / count[k];
  return quarter < S(0.055) * static_cast<S>(samples.size()) && spread < all * S(0.0016) * box.extent().squaredNorm();
}

// Above 0 if the body looks along `front`: its toes are before its shins, its head before its middle. One that stands
// upright is told by its toes. One that is long, low and narrow swims, crawls or flies, and tapers from its head to its
// tail, whatever fin stands up there.
template <class S>
S forwardness(Span<const Vec3<S>> samples, const Vec3<S>& up, const Vec3<S>& front) {
  const Bounds<S> box = bounds(samples);
  const S tall = std::abs(up.dot(box.extent())), low = std::min(up.dot(box.low), up.dot(box.high));
  const S length = std::abs(front.dot(box.extent()));
  if (!(tall > S(0)) || !(length > S(0))) return S(0);
  const Vec3<S> across = up.cross(front).cwiseAbs();
  const S middle = across.dot(box.low + box.high) / S(2);
  std::array<S, 6> sum{}, count{};  // toes and shins on either side, head, all
  for (const Vec3<S>& p : samples) {
    const S h = (up.dot(p) - low) / tall, f = front.dot(p);
    const std::size_t side = across.dot(p) > middle ? 1 : 0;
    const auto add = [&](std::size_t k) {
      sum[k] += f;
      count[k] += S(1);
    };
    if (h < S(0.06)) add(side);
    if (h > S(0.1) && h < S(0.2)) add(2 + side);
    if (h > S(0.75)) add(4);
    add(5);
  }
  const auto mean = [&](std::size_t k) { return count[k] > S(0) ? sum[k] / count[k] : sum[5] / count[5]; };
  S toes = 0;
  if (std::all_of(count.begin(), count.begin() + 4, [](S c) { return c > S(0); })) {
    toes = (mean(0) - mean(2) + mean(1) - mean(3)) / (S(2) * tall);  // of one in mid stride each foot counts alone
  } else {
    for (const std::size_t k : {0u, 2u}) {
      sum[k] += sum[k + 1];
      count[k] += count[k + 1];
    }
    toes = (mean(0) - mean(2)) / tall;
  }
  const S top = (mean(4) - mean(5)) / std::max(length, tall);
  if (length < S(0.8) * tall) return S(3) * toes + S(0.5) * top;
  // Ears may reach as high as the lower part of such a tail, which is at one end and no lid's knob.
  const bool tail_is_high =
      ends_thin(samples, up, S(0.75)) || (std::abs(top) > S(0.2) && ends_thin(samples, up, S(0.85)));
  S score = toes + (tail_is_high ? -top : top);
  if (length > S(1.5) * tall && across.dot(box.extent()) < S(0.6) * length) {
    const S back = std::min(front.dot(box.low), front.dot(box.high));
    std::array<S, 2> wide{}, many{};  // in the last quarter, in the first
    for (const Vec3<S>& p : samples) {
      const S f = (front.dot(p) - back) / length;
      if (f > S(0.25) && f < S(0.75)) continue;
      const std::size_t k = f > S(0.5) ? 1 : 0;
      wide[k] += std::abs(across.dot(p) - middle);
      many[k] += S(1);
    }
    if (many[0] > S(0) && many[1] > S(0)) score += S(2) * (wide[1] / many[1] - wide[0] / many[0]) / tall;
  }
  return score;
}

// The axes of a body from M samples of its surface, its tips and the plane that fits it best, which may fit badly: left
// and right are across it. Where nothing speaks for another answer it is that of the file's kind, mostly +y up and +z
// front. No allocation.
template <class S>
PostureGuess<S> guess_posture(Span<const Vec3<S>> samples, Span<const Vec3<S>> tips, const SymmetryPlane<S>& plane,
                              FileAxes file) {
  PostureGuess<S> guess;
  Posture<S>& posture = guess.posture;
  if (samples.empty()) return guess;
  int across = -1;  // the file's axis from side to side
  if (plane.misfit < S(0.035)) plane.normal.cwiseAbs().maxCoeff(&across);
  S best = -std::numeric_limits<S>::max(), second = best;
  for (const int k : {2, 4, 5, 3, 0, 1}) {
    const Vec3<S> up = signed_axis<S>(k);
    if (k / 2 == across && usual_up(file, up) < S(3)) continue;
    const S score = usual_up(file, up) + uprightness(samples, tips, plane, up);
    if (score <= best + S(0.01)) {
      second = std::max(second, score);
      continue;
    }
    second = best;
    best = score;
    posture.up = up;
  }
  if (across < 0 || std::abs(posture.up[across]) > S(0.5)) across = std::abs(posture.up.x()) > S(0.5) ? 1 : 0;
  posture.front = posture.up.cross(Vec3<S>::Unit(across)).cwiseAbs();
  if (std::abs(posture.up.z()) > S(0.5)) posture.front = -posture.front;  // the front of a file whose z is up is -y
  const bool usual = std::abs(posture.front.x()) < S(0.5);
  const S forward = forwardness(samples, posture.up, posture.front) + usual_front<S>(usual ? file : FileAxes::unknown);
  if (forward < S(0)) posture.front = -posture.front;
  posture.left = posture.up.cross(posture.front);
  guess.sure = std::min({S(1), best - second, S(10) * std::abs(forward)});
  return guess;
}

}  // namespace rigless::detail
