// Times calls: a few runs to warm up, then the median and the 95th percentile of many, and what they allocate.
// Include it in one source file only: it replaces malloc to count.
#pragma once

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "rigless/math/types.h"  // clang declares posix_memalign once more among the vectors that Eigen includes

namespace rigless_bench {

inline std::int64_t allocations = 0;

// What the compiler was allowed to use; the same source is built more than once.
#if defined(__AVX2__)
inline constexpr const char* build = "avx2";
#elif defined(__SSE2__)
inline constexpr const char* build = "sse2";
#else
inline constexpr const char* build = "native";
#endif

struct Contender {
  std::string name;
  std::function<void()> work;
  std::function<void()> before = [] {};  // each time, not timed
};

// Arguments: --csv FILE appends one row per figure; --small runs everything once, to see that it works.
class Bench {
 public:
  Bench(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      if (std::strcmp(argv[i], "--small") == 0) small_ = true;
      if (std::strcmp(argv[i], "--csv") == 0 && i + 1 < argc) csv_ = argv[++i];
    }
  }

  bool small() const { return small_; }

  // Calls work() repeatedly and reports it under `name`. Gives the median in milliseconds.
  template <class F>
  double run(const std::string& name, F&& work, std::size_t runs = 50) {
    return run(name, work, runs, [] {});
  }

  // The same with something before each call that is not timed.
  template <class F, class G>
  double run(const std::string& name, F&& work, std::size_t runs, G&& before) {
    if (small_) runs = 1;
    std::vector<double> ms;
    ms.reserve(runs);
    std::int64_t allocated = 0;
    for (std::size_t i = 0; i < runs + (small_ ? 0 : 5); ++i) {
      before();
      const std::int64_t already = allocations;
      const double t = time(work);
      if (!small_ && i < 5) continue;
      allocated += allocations - already;
      ms.push_back(t);
    }
    return report(name, ms, static_cast<double>(allocated) / static_cast<double>(runs));
  }

  // Calls all in turns, so that a busy machine is unfair to none: in each round everyone runs once to warm the caches
  // and then `burst` times. Reports each, and how many times longer each of the others took than the first.
  void compare(const std::string& title, const std::vector<Contender>& contenders, int rounds = 15, int burst = 3) {
    if (small_) rounds = burst = 1;
    std::vector<std::vector<double>> all(contenders.size()), of_round(contenders.size());
    std::vector<std::int64_t> allocated(contenders.size(), 0);
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t c = 0; c < contenders.size(); ++c) {
        const Contender& who = contenders[c];
        std::vector<double> ms;
        ms.reserve(static_cast<std::size_t>(burst));
        for (int i = small_ ? 0 : -1; i < burst; ++i) {
          who.before();
          const std::int64_t already = allocations;
          const double t = time(who.work);
          if (i < 0) continue;
          allocated[c] += allocations - already;
          ms.push_back(t);
        }
        all[c].insert(all[c].end(), ms.begin(), ms.end());
        of_round[c].push_back(quantile(ms, 0.5));
      }
    }
    for (std::size_t c = 0; c < contenders.size(); ++c) {
      report(title + ": " + contenders[c].name, all[c], static_cast<double>(allocated[c]) / (rounds * burst));
    }
    for (std::size_t c = 1; c < contenders.size(); ++c) {
      std::vector<double> ratio;
      for (std::size_t r = 0; r < of_round[c].size(); ++r) ratio.push_back(of_round[c][r] / of_round[0][r]);
      figure(title + ": " + contenders[c].name + " / " + contenders[0].name, quantile(ratio, 0.5), "x",
             quantile(ratio, 0.95));
    }
  }

  // Reports something that is not a time.
  void figure(const std::string& name, double value, const char* unit, double p95 = -1) {
    std::printf("%-4s %-72s %11.4g %s\n", build, name.c_str(), value, unit);
    std::fflush(stdout);
    char numbers[96];
    if (p95 < 0) {
      std::snprintf(numbers, sizeof numbers, "%.5g,,%s,", value, unit);
    } else {
      std::snprintf(numbers, sizeof numbers, "%.5g,%.5g,%s,", value, p95, unit);
    }
    row(name, numbers);
  }

 private:
  // Processor time of this thread: what others do meanwhile is not ours.
  static double now() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
  }

  template <class F>
  static double time(F& work) {
    const double start = now();
    work();
    return now() - start;
  }

  static double quantile(std::vector<double> values, double q) {
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<std::size_t>(q * static_cast<double>(values.size())))];
  }

  double report(const std::string& name, const std::vector<double>& ms, double allocated) {
    const double median = quantile(ms, 0.5), p95 = quantile(ms, 0.95);
    std::printf("%-4s %-72s %11.4f ms   p95 %10.4f ms   %6.1f allocations\n", build, name.c_str(), median, p95,
                allocated);
    std::fflush(stdout);
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "%.4f,%.4f,ms,%.1f", median, p95, allocated);
    row(name, numbers);
    return median;
  }

  void row(const std::string& name, const char* numbers) const {
    if (csv_.empty()) return;
    std::FILE* file = std::fopen(csv_.c_str(), "a");
    if (file == nullptr) std::exit(1);
    std::string field = name;
    std::replace(field.begin(), field.end(), ',', ';');
    std::fprintf(file, "%s,%s,%s\n", build, field.c_str(), numbers);
    std::fclose(file);
  }

  bool small_ = false;
  std::string csv_;
};

// Says what went wrong and leaves: a benchmark whose numbers mean nothing has failed.
[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::exit(1);
}

}  // namespace rigless_bench

// glibc lets a program define these itself; operator new, aligned or not, and Eigen's memory all come through here.
extern "C" {
void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* memory, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;

void* malloc(std::size_t size) noexcept {
  ++rigless_bench::allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  ++rigless_bench::allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  ++rigless_bench::allocations;
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++rigless_bench::allocations;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  ++rigless_bench::allocations;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
}
