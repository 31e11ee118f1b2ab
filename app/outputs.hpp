// The files that a run leaves: opened before it flies, so that a wrong path costs no flight.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/arguments.hpp"
#include "controller/flight/observer.hpp"
#include "controller/flight/summary.hpp"
#include "controller/scenario/scenario.hpp"
#include "record/csv_recorder.hpp"
#include "record/output_file.hpp"
#include "record/path_sampler.hpp"

namespace mayfly::app {

class Outputs {
 public:
  // Nothing stays behind where one cannot be opened.
  static Result<Outputs> open(const RunOptions& options, const Scenario& scenario, std::size_t agents);

  std::span<Observer* const> observers() const noexcept { return observers_; }

  // Writes them all; one that fails does not keep the others from being written.
  std::vector<Error> finish(const Scenario& scenario, const Summary& summary);

 private:
  Outputs() = default;
  void finish_recording(std::vector<Error>& errors);

  std::unique_ptr<record::CsvRecorder> recorder_;
  std::unique_ptr<record::PathSampler> sampler_;
  std::optional<record::OutputFile> plot_;
  std::optional<record::OutputFile> summary_;
  std::vector<Observer*> observers_;
};

}  // namespace mayfly::app
