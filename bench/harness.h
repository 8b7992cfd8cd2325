// Times a call: a few runs to warm up, then the median and the 95th percentile of many, and what it allocates.
// Include it in one source file only: it replaces malloc to count.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace rigless_bench {

inline std::int64_t allocations = 0;

// Arguments: --csv FILE appends one row per measurement; --small runs everything once, to see that it works.
class Bench {
 public:
  Bench(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      if (std::strcmp(argv[i], "--small") == 0) small_ = true;
      if (std::strcmp(argv[i], "--csv") == 0 && i + 1 < argc) csv_ = argv[++i];
    }
  }

  bool small() const { return small_; }

  // Calls work() repeatedly and reports it under `name` (no commas).
  template <class F>
  void run(const std::string& name, F&& work) {
    const int warm_up = small_ ? 0 : 5;
    const std::size_t runs = small_ ? 1 : 50;
    for (int i = 0; i < warm_up; ++i) work();
    std::vector<double> ms(runs);
    const std::int64_t allocations_before = allocations;
    for (double& t : ms) {
      const auto start = std::chrono::steady_clock::now();
      work();
      t = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }
    const double allocated = static_cast<double>(allocations - allocations_before) / static_cast<double>(runs);
    std::sort(ms.begin(), ms.end());
    report(name, ms[runs / 2], ms[runs * 95 / 100], allocated);
  }

 private:
  void report(const std::string& name, double median, double p95, double allocated) const {
    std::printf("%-48s median %10.4f ms   p95 %10.4f ms   %6.1f allocations\n", name.c_str(), median, p95, allocated);
    if (csv_.empty()) return;
    std::FILE* file = std::fopen(csv_.c_str(), "a");
    if (file == nullptr) std::exit(1);
    std::fprintf(file, "%s,%.4f,%.4f,%.1f\n", name.c_str(), median, p95, allocated);
    std::fclose(file);
  }

  bool small_ = false;
  std::string csv_;
};

}  // namespace rigless_bench

// glibc lets a program define malloc itself; Eigen's memory and operator new both come through here.
extern "C" void* __libc_malloc(std::size_t size) noexcept;
extern "C" void* malloc(std::size_t size) noexcept {
  ++rigless_bench::allocations;
  return __libc_malloc(size);
}
