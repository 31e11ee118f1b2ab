// The rows of what stands in the world.
#include <string>

#include "controller/scenario/schema_rows.hpp"

namespace mayfly {
namespace {

using Rows = std::vector<Key>;

void add_brush_rows(Rows& rows) {
  const std::string at = "world.brushes[]";
  rows.push_back({.path = "world.brushes",
                  .type = KeyType::kList,
                  .max = 1000,
                  .fallback = "[]",
                  .text = "Where you want agents, or don't: each at full strength in its centre and gone at "
                          "its radius."});
  rows.push_back({.path = at, .type = KeyType::kMap, .text = "One brush: `attract` or `repel`."});
  for (const std::string effect : {"attract", "repel"}) {
    const std::string path = at + "." + effect;
    rows.push_back({.path = path,
                    .type = KeyType::kMap,
                    .group = "brush",
                    .text = effect == "attract" ? "Draws agents in." : "Keeps agents away."});
    rows.push_back({.path = path + ".center",
                    .type = KeyType::kVector,
                    .unit = "m",
                    .min = -kFarthest,
                    .max = kFarthest,
                    .required = true,
                    .text = "Its centre."});
    rows.push_back({.path = path + ".radius",
                    .type = KeyType::kNumber,
                    .unit = "m",
                    .min = 0.0,
                    .max = kFarthest,
                    .above_min = true,
                    .required = true,
                    .text = "How far it reaches."});
    rows.push_back({.path = path + ".strength",
                    .type = KeyType::kNumber,
                    .unit = "1/m or m/s",
                    .min = 0.0,
                    .max = 1e6,
                    .above_min = true,
                    .required = true,
                    .text = effect == "attract"
                                ? "Of a cost, what a metre in the centre costs less; of a potential, the "
                                  "velocity where it is steepest."
                                : "Of a cost, what a metre in the centre costs more; of a potential, the "
                                  "velocity where it is steepest."});
    rows.push_back(
        {.path = path + ".term",
         .type = KeyType::kChoice,
         .fallback = "cost",
         .choices = {"cost", "potential"},
         .text = "`cost` changes the ways that are planned, `potential` the velocity right there."});
  }
  add_swarm_of_row(rows, at);
}

}  // namespace

void add_swarm_of_row(Rows& rows, const std::string& path) {
  rows.push_back({.path = path + ".swarm",
                  .type = KeyType::kName,
                  .fallback_text = "all swarms",
                  .text = "The one swarm that feels it."});
}

void add_world_rows(Rows& rows) {
  rows.push_back(
      {.path = "world", .type = KeyType::kMap, .required = true, .text = "Where the swarm flies."});
  rows.push_back({.path = "world.bounds",
                  .type = KeyType::kMap,
                  .required = true,
                  .text = "The box that the fields cover; agents stay inside."});
  rows.push_back({.path = "world.bounds.min",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "The corner with the smallest coordinates."});
  rows.push_back({.path = "world.bounds.max",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "The corner with the largest coordinates, larger than `min` in all three."});
  rows.push_back(
      {.path = "world.fence",
       .type = KeyType::kList,
       .max = 100,
       .fallback = "[]",
       .text = "Planes that robots under the governor stay on one side of, besides the bounds: what is "
               "left is convex."});
  rows.push_back({.path = "world.fence[]",
                  .type = KeyType::kMap,
                  .text = "One plane: robots stay where normal · x <= offset."});
  rows.push_back({.path = "world.fence[].normal",
                  .type = KeyType::kVector,
                  .min = -1e6,
                  .max = 1e6,
                  .required = true,
                  .text = "Points out of the fence; its length does not matter."});
  rows.push_back({.path = "world.fence[].offset",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .required = true,
                  .text = "How far along the normal the plane is from the origin."});
  rows.push_back({.path = "world.cell",
                  .type = KeyType::kNumber,
                  .unit = "m",
                  .min = 0.001,
                  .max = 1000.0,
                  .fallback = "1.0",
                  .text = "The side of one cell of the grid that distance and cost are kept on."});
  rows.push_back(
      {.path = "world.coarse_cell",
       .type = KeyType::kNumber,
       .unit = "m",
       .min = 0.001,
       .max = 1000.0,
       .fallback_text = "one grid, all of `cell`",
       .text = "For large worlds, cells of this side away from obstacles and goals: eight of `cell`."});
  rows.push_back({.path = "world.obstacles",
                  .type = KeyType::kList,
                  .max = 10'000,
                  .fallback = "[]",
                  .text = "What agents must not enter."});
  rows.push_back(
      {.path = "world.obstacles[]", .type = KeyType::kMap, .text = "One obstacle: exactly one shape."});
  add_shape_rows(rows, "world.obstacles[]", ShapeSet::kObstacle);
  rows.push_back({.path = "world.goals",
                  .type = KeyType::kNamedMap,
                  .fallback = "{}",
                  .text = "The places swarms fly to, by name."});
  rows.push_back({.path = "world.goals.*", .type = KeyType::kMap, .text = "One goal: exactly one shape."});
  add_shape_rows(rows, "world.goals.*", ShapeSet::kGoal);
  add_brush_rows(rows);
}

}  // namespace mayfly
