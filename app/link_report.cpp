#include "app/link_report.hpp"

#include <fmt/format.h>

#include <string>

#include "record/output_file.hpp"

namespace mayfly::app {

Result<void> write_link_report(const std::filesystem::path& path, const link::LinkReport& report,
                               Time epoch) {
  std::string stops;
  for (const link::Stop& stop : report.stops) {
    stops += fmt::format("{}\n    {{\"wished_ns\": {}, \"still_ns\": {}, \"late_ns\": {}}}",
                         stops.empty() ? "" : ",", (epoch + stop.wished).count(),
                         (epoch + stop.still).count(), stop.late.count());
  }
  const std::string gone =
      report.planner_gone == Time(0) ? "null" : std::to_string((epoch + report.planner_gone).count());
  const std::string witness = report.witness
                                  ? fmt::format("{{\"p50\": {:.3f}, \"p99\": {:.3f}, \"max\": {:.3f}}}",
                                                report.witness->p50, report.witness->p99, report.witness->max)
                                  : "null";
  return record::write_file(
      path,
      fmt::format("{{\n  \"planner_died\": {},\n  \"planner_gone_ns\": {},\n  \"ticks\": {},\n"
                  "  \"skipped\": {},\n  \"wishes\": {},\n  \"refused\": {},\n  \"leases_refused\": {},\n"
                  "  \"stops\": [{}],\n"
                  "  \"witness_us\": {}\n}}\n",
                  report.planner_died, gone, report.ticks, report.skipped, report.wishes, report.refused,
                  report.leases_refused, stops, witness));
}

}  // namespace mayfly::app
