// The rows of what moves a swarm where fields alone do not, of collision avoidance, and of who is there.
#include <string>

#include "controller/scenario/schema_rows.hpp"

namespace mayfly {
namespace {

using Rows = std::vector<Key>;

void add_map(Rows& rows, const std::string& path, const std::string& text) {
  rows.push_back({.path = path, .type = KeyType::kMap, .text = text});
}

struct NumberRow {
  std::string path, unit, fallback, text;
  double max = 1e6;
};

// From 0 up.
void add_number(Rows& rows, const NumberRow& row) {
  rows.push_back({.path = row.path,
                  .type = KeyType::kNumber,
                  .unit = row.unit,
                  .min = 0.0,
                  .max = row.max,
                  .fallback = row.fallback,
                  .text = row.text});
}

void add_forces_rows(Rows& rows, const std::string& path) {
  add_map(rows, path,
          "The model `forces`: interaction zones and friction, with the noise as a force (BSwarm15 §4, "
          "Ren16); the defaults are the midges of BSwarm15.");
  add_number(rows,
             {path + ".friction", "1/m", "11.16", "Friction γ: grows with the square of the speed.", 1e4});
  add_map(rows, path + ".repulsion", "The innermost zone: away from whoever is in it.");
  add_number(rows, {path + ".repulsion.weight", "m/s²", "5.61", "χ_rep."});
  add_number(rows, {path + ".repulsion.radius", "m", "0.17", "r_rep: where the zone ends.", kFarthest});
  add_map(rows, path + ".alignment", "The zone around it: as the others fly.");
  add_number(rows, {path + ".alignment.weight", "m/s²", "0", "χ_ali."});
  add_number(rows, {path + ".alignment.width", "m", "0",
                    "r*_ali: how much farther out than repulsion it reaches.", kFarthest});
  add_map(rows, path + ".attraction", "The outermost zone: toward whoever is in it.");
  add_number(rows, {path + ".attraction.weight", "m/s²", "14.29", "χ_att."});
  add_number(rows, {path + ".attraction.width", "m", "5.12",
                    "r*_att: how much farther out than alignment it reaches.", kFarthest});
  add_number(rows, {path + ".far_error", "", "0",
                    "By how much the mean attraction of far groups may be off, so that they can be summed as "
                    "one; 0 is exact.",
                    0.5});
}

void add_boids_rows(Rows& rows, const std::string& path) {
  add_map(rows, path, "The model `boids` (Reynolds 1987), to compare others with.");
  const auto rule = [&](const std::string& name, const std::string& unit, const std::string& weight,
                        const std::string& radius, const std::string& text) {
    add_map(rows, path + "." + name, text);
    add_number(rows, {path + "." + name + ".weight", unit, weight, "How strong it is."});
    add_number(rows, {path + "." + name + ".radius", "m", radius, "Whom it counts.", kFarthest});
  };
  rule("separation", "m/s²", "1.5", "0.5", "Away from those too near.");
  rule("alignment", "1/s", "1", "1.5", "To the mean velocity of those around.");
  rule("cohesion", "1/s²", "1", "1.5", "To the middle of those around.");
  rows.push_back({.path = path + ".speed",
                  .type = KeyType::kNumber,
                  .unit = "m/s",
                  .min = 0.0,
                  .max = 1000.0,
                  .above_min = true,
                  .fallback = "1",
                  .text = "The speed they keep."});
}

void add_brownian_rows(Rows& rows, const std::string& path) {
  add_map(rows, path,
          "The model `brownian`: active Brownian particles in a parabolic potential (Schweitzer 1998), to "
          "compare others with.");
  add_number(rows, {path + ".friction", "1/s", "1", "γ0."});
  add_number(rows, {path + ".intake", "m²/s³", "2", "q, what the energy depot takes in."});
  add_number(rows, {path + ".dissipation", "1/s", "1", "c, what it loses."});
  add_number(rows, {path + ".conversion", "s/m²", "1", "d, how it drives the particle."});
  add_number(rows, {path + ".noise", "m/s^1.5", "0.2", "√(2D), the strength of the white noise."});
  add_number(rows, {path + ".pull", "1/s²", "1", "a, of the potential."});
  rows.push_back({.path = path + ".center",
                  .type = KeyType::kVector,
                  .unit = "m",
                  .min = -kFarthest,
                  .max = kFarthest,
                  .fallback_text = "the middle of the start region",
                  .text = "The potential's centre."});
}

void add_avoidance_rows(Rows& rows, const std::string& path) {
  add_map(rows, path, "Collision avoidance, after whichever model.");
  rows.push_back({.path = path + ".kind",
                  .type = KeyType::kChoice,
                  .fallback_text = "`orca` for the models `forces` and `orca`, else `none`",
                  .choices = {"orca", "none"},
                  .text = "`orca`: reciprocal half-spaces in three dimensions (van den Berg et al. 2011)."});
  const auto positive = [&](const std::string& name, const std::string& unit, double max,
                            const std::string& fallback, const std::string& fallback_text,
                            const std::string& text) {
    rows.push_back({.path = path + "." + name,
                    .type = KeyType::kNumber,
                    .unit = unit,
                    .min = 0.0,
                    .max = max,
                    .above_min = true,
                    .fallback = fallback,
                    .fallback_text = fallback_text,
                    .text = text});
  };
  positive("horizon", "s", 1000.0, "1", "", "For so long agents keep clear of each other.");
  positive("wall_horizon", "s", 1000.0, "0.5", "", "For so long they keep clear of obstacles.");
  positive("range", "m", kFarthest, "", "from where two at top speed could meet within the horizon",
           "Nobody farther off is considered.");
  rows.push_back({.path = path + ".neighbours",
                  .type = KeyType::kInteger,
                  .min = 1,
                  .max = 16,
                  .fallback = "10",
                  .text = "Of those in range, the nearest so many are considered."});
  rows.push_back({.path = path + ".strict",
                  .type = KeyType::kFlag,
                  .fallback = "off",
                  .text = "Two share out the gap between them before every tick: none that are strict touch, "
                          "even in a jam, but dense flocks become slower."});
}

void add_roster_rows(Rows& rows, const std::string& at) {
  const auto rate = [&](const std::string& path, const std::string& text) {
    rows.push_back({.path = path,
                    .type = KeyType::kNumber,
                    .unit = "1/s",
                    .min = 0.0,
                    .max = 1e6,
                    .above_min = true,
                    .required = true,
                    .text = text});
  };
  const auto agents = [&](const std::string& path, double min, const std::string& text) {
    rows.push_back(
        {.path = path, .type = KeyType::kInteger, .min = min, .max = 2e6, .required = true, .text = text});
  };
  add_map(rows, at + ".join", "Agents that join in flight; without it, all are there from the start.");
  agents(at + ".join.first", 0, "So many are there at the start: those with the lowest numbers.");
  rate(at + ".join.rate", "The others join in the order of their numbers, so many a second.");
  add_map(rows, at + ".leave", "Agents that leave in flight, as robots that drop out do.");
  rows.push_back({.path = at + ".leave.after",
                  .type = KeyType::kNumber,
                  .unit = "s",
                  .min = 0.0,
                  .max = 1e6,
                  .required = true,
                  .text = "When the first leaves: the one with the lowest number."});
  rate(at + ".leave.rate", "The others follow in the order of their numbers, so many a second.");
  agents(at + ".leave.count", 1, "How many leave.");
}

}  // namespace

void add_model_rows(std::vector<Key>& rows, const std::string& at) {
  add_forces_rows(rows, at + ".forces");
  add_boids_rows(rows, at + ".boids");
  add_brownian_rows(rows, at + ".brownian");
  add_avoidance_rows(rows, at + ".avoidance");
  rows.push_back({.path = at + ".temperature",
                  .type = KeyType::kNumber,
                  .unit = "°C",
                  .min = 8.75,
                  .max = 35.65,
                  .fallback_text = "25: radii as they are given",
                  .text = "Scales the zones of `forces` and `boids` with the distance that insects keep at "
                          "this temperature, as the inverse cube root of their density (Ren16 Eq. 1)."});
  add_roster_rows(rows, at);
}

}  // namespace mayfly
