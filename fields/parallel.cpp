#include "fields/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <system_error>
#include <thread>
#include <vector>

namespace mayfly::fields {
namespace {

constexpr std::chrono::milliseconds kBetweenReports{250};

}  // namespace

void parallel_for(std::size_t count, int threads, std::string_view stage, const Progress& progress,
                  const WorkReference& work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next.fetch_add(1); i < count; i = next.fetch_add(1)) {
      work(i);
    }
  };
  const auto run_and_report = [&] {
    auto reported = std::chrono::steady_clock::now();
    for (std::size_t i = next.fetch_add(1); i < count; i = next.fetch_add(1)) {
      work(i);
      if (progress && std::chrono::steady_clock::now() - reported > kBetweenReports) {
        reported = std::chrono::steady_clock::now();
        progress(stage, static_cast<double>(i) / static_cast<double>(count));
      }
    }
  };
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t wanted = threads < 1 ? cores : static_cast<std::size_t>(threads);
  std::vector<std::jthread> helpers;
  try {
    for (std::size_t i = 1; i < std::min(wanted, count); ++i) {
      helpers.emplace_back(run);
    }
  } catch (const std::system_error&) {
    // No more threads to be had: those that started, and this one, do the work.
  }
  run_and_report();
}

}  // namespace mayfly::fields
