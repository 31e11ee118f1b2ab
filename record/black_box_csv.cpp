#include "record/black_box_csv.hpp"

#include <fmt/format.h>

#include <iterator>

#include "controller/life_cycle/transitions.hpp"
#include "controller/safety/reaction_table.hpp"

namespace mayfly::record {
namespace {

std::string joined(Symptoms symptoms) {
  std::string text;
  for (std::size_t s = 0; s < kSymptoms; ++s) {
    if (symptoms.has(static_cast<Symptom>(s))) {
      text += text.empty() ? "" : "+";
      text += info_of(static_cast<Symptom>(s)).name;
    }
  }
  return text;
}

}  // namespace

std::string black_box_csv(const BlackBoxTape& tape, std::span<const std::string> robots) {
  std::string text(kBlackBoxHeader);
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < tape.size(); ++i) {
    const BlackBoxFrame& frame = tape.frame(i);
    const std::string tick = fmt::format("{},{},{},{}", to_seconds(frame.time), frame.sequence,
                                         frame.held ? 1 : 0, joined(frame.everybody));
    if (tape.robots() == 0) {
      fmt::format_to(out, "{},,,,,,,,,,,,,,,,,,,\n", tick);
    }
    for (std::size_t robot = 0; robot < tape.robots(); ++robot) {
      const BlackBoxRow& r = tape.rows(i)[robot];
      fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", tick,
                     robot < robots.size() ? robots[robot] : std::to_string(robot), r.x, r.y, r.z, r.vx, r.vy,
                     r.vz, r.known, name_of(r.state), key_of(r.severity), joined(r.symptoms), name_of(r.wish),
                     r.wish_x, r.wish_y, r.wish_z, name_of(r.sent), r.sent_x, r.sent_y, r.sent_z);
    }
  }
  return text;
}

}  // namespace mayfly::record
