#include "app/outputs.hpp"

#include <fmt/format.h>

#include <system_error>

#include "app/log.hpp"
#include "record/path_plot.hpp"
#include "record/summary_json.hpp"

namespace mayfly::app {
namespace {

Result<void> open_if_wanted(const std::filesystem::path& path, std::optional<record::OutputFile>& file) {
  if (path.empty()) {
    return {};
  }
  auto opened = record::OutputFile::create(path);
  if (!opened) {
    return fail(std::move(opened.error()));
  }
  file.emplace(std::move(*opened));
  return {};
}

Result<void> write_whole(record::OutputFile& file, std::string_view text) {
  if (!file.write(text)) {
    return fail(Cause::kEnvironment, fmt::format("cannot write '{}': {}", file.path().string(),
                                                 std::generic_category().message(file.error_number())));
  }
  return file.commit();
}

}  // namespace

Result<Outputs> Outputs::open(const RunOptions& options, const Scenario& scenario, std::size_t agents) {
  Outputs outputs;
  if (auto opened = open_if_wanted(options.summary, outputs.summary_); !opened) {
    return fail(std::move(opened.error()));
  }
  if (auto opened = open_if_wanted(options.plot, outputs.plot_); !opened) {
    return fail(std::move(opened.error()));
  }
  if (outputs.plot_) {
    outputs.sampler_ = std::make_unique<record::PathSampler>(agents);
    outputs.observers_.push_back(outputs.sampler_.get());
  }
  if (!options.record.empty()) {
    auto recorder = record::CsvRecorder::open(options.record,
                                              {agents, static_cast<double>(scenario.record.rate),
                                               static_cast<double>(scenario.control.rate), !options.fast});
    if (!recorder) {
      return fail(std::move(recorder.error()));
    }
    outputs.recorder_ = std::move(*recorder);
    outputs.observers_.push_back(outputs.recorder_.get());
  }
  return outputs;
}

void Outputs::finish_recording(std::vector<Error>& errors) {
  auto report = recorder_->close();
  if (!report) {
    errors.push_back(std::move(report.error()));
  } else if (report->lost > 0) {
    log_warning(
        fmt::format("{} of {} recorded frames were lost: the recording has gaps, each marked by a line",
                    report->lost, report->lost + report->frames));
  }
}

std::vector<Error> Outputs::finish(const Scenario& scenario, const Summary& summary) {
  std::vector<Error> errors;
  const auto note = [&](Result<void> done) {
    if (!done) {
      errors.push_back(std::move(done.error()));
    }
  };
  if (recorder_) {
    finish_recording(errors);
  }
  if (summary_) {
    note(write_whole(*summary_, record::to_json(summary)));
  }
  if (plot_) {
    note(record::draw_path_plot(scenario, summary, *sampler_).and_then([&](const std::string& png) {
      return write_whole(*plot_, png);
    }));
  }
  return errors;
}

}  // namespace mayfly::app
