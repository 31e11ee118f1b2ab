// What a guard's black box has kept, as CSV.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "controller/guard/black_box.hpp"
#include "core/hal.hpp"

namespace mayfly::record {

inline constexpr std::string_view kBlackBoxHeader =
    "t,sequence,held,everybody,robot,x,y,z,vx,vy,vz,known,state,severity,symptoms,wish,wish_x,wish_y,wish_z,"
    "sent,"
    "sent_x,sent_y,sent_z\n";

// One line a robot and tick, oldest first; t in s on the run's clock, m, m/s, world frame. Symptoms are
// joined by
// '+'. Numbers are written in the fewest digits that give the same float back. A tick of nobody has one line,
// with no robot.
std::string black_box_csv(const BlackBoxTape& tape, std::span<const std::string> robots);

}  // namespace mayfly::record
