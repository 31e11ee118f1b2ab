#include "record/summary_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace mayfly::record {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::ElementsAre;

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) {
    keys.push_back(key);
  }
  return keys;
}

Summary full() {
  Summary summary;
  summary.control.tasks.emplace_back().name = "control";
  summary.control.ages.emplace_back().name = "curl_noise to control";
  summary.faults.push_back({1.5, "flies_3", "sim", "silent", "hold"});
  summary.faults.push_back({1.6, "", "sim", "bus off"});
  summary.safety.invariants.emplace_back("separation", 2);
  summary.safety.reactions.emplace_back("hold", 3);
  summary.expect.push_back({"reached flies at exit", 1.0, ">= 0.99", true});
  return summary;
}

TEST(SummaryJson, KeysAreTheContract) {
  const auto json = Json::parse(to_json(full()));
  EXPECT_THAT(keys_of(json),
              ElementsAre("scenario", "engine", "hal", "seed", "agents", "ticks", "simulated_s", "wall_s",
                          "realtime_factor", "ns_per_agent_tick", "reached_fraction", "min_separation_m",
                          "collisions", "penetrations", "mde_percent", "infeasible_agents",
                          "governor_interventions", "faults", "safety", "max_speed_mps",
                          "max_acceleration_mps2", "control", "preprocessing_s", "fields", "expect"));
  EXPECT_THAT(keys_of(json["safety"]),
              ElementsAre("severity_max", "invariants", "reactions", "wishes_refused", "stalled_ticks",
                          "incidents", "breaches"));
  EXPECT_EQ(json["safety"]["invariants"]["separation"], 2);
  EXPECT_EQ(json["safety"]["reactions"]["hold"], 3);
  EXPECT_THAT(keys_of(json["control"]),
              ElementsAre("rate_hz", "ticks", "missed", "missed_by_machine", "jitter_us", "run_us",
                          "realtime", "missing_rights", "witness_us", "tasks", "ages"));
  EXPECT_THAT(keys_of(json["control"]["tasks"][0]),
              ElementsAre("name", "thread", "rate_hz", "ticks", "missed", "missed_by_machine", "jitter_us",
                          "run_us"));
  EXPECT_THAT(keys_of(json["control"]["ages"][0]), ElementsAre("name", "limit_s", "expired", "age_s"));
  EXPECT_THAT(keys_of(json["control"]["jitter_us"]), ElementsAre("p50", "p99", "p999", "max"));
  EXPECT_THAT(keys_of(json["control"]["run_us"]), ElementsAre("p50", "p99", "p999", "max"));
  EXPECT_THAT(keys_of(json["preprocessing_s"]), ElementsAre("distance", "noise", "cost"));
  EXPECT_THAT(keys_of(json["fields"]), ElementsAre("updates", "age_s", "solve_s", "unreachable"));
  EXPECT_THAT(keys_of(json["fields"]["age_s"]), ElementsAre("p50", "p99", "max"));
  EXPECT_THAT(keys_of(json["faults"][0]), ElementsAre("time_s", "robot", "link", "cause", "severity"));
  EXPECT_EQ(json["faults"][0]["severity"], "hold");
  EXPECT_TRUE(json["faults"][1]["severity"].is_null()) << "not a reaction of the guard's";
  EXPECT_THAT(keys_of(json["expect"][0]), ElementsAre("name", "value", "wanted", "pass"));
}

TEST(SummaryJson, WhatWasNotMeasuredIsNull) {
  const auto json = Json::parse(to_json(Summary{}));
  for (const char* key :
       {"ns_per_agent_tick", "reached_fraction", "min_separation_m", "collisions", "penetrations",
        "mde_percent", "infeasible_agents", "max_speed_mps", "max_acceleration_mps2"}) {
    EXPECT_TRUE(json[key].is_null()) << key;
  }
  EXPECT_TRUE(json["fields"]["updates"].is_null());
  EXPECT_TRUE(json["fields"]["age_s"]["max"].is_null());
  EXPECT_TRUE(json["faults"].is_array());
  EXPECT_TRUE(json["expect"].empty());
}

TEST(SummaryJson, WhatIsNoNumberIsNull) {
  Summary summary;
  summary.min_separation_m = std::nan("");
  summary.wall_s = INFINITY;
  const auto json = Json::parse(to_json(summary));
  EXPECT_TRUE(json["min_separation_m"].is_null());
  EXPECT_TRUE(json["wall_s"].is_null());
}

TEST(SummaryJson, NamesMayHoldAnything) {
  Summary summary;
  summary.scenario = "\"quoted\"\n\xff";
  EXPECT_TRUE(Json::accept(to_json(summary)));
}

TEST(SummaryJson, ValuesArrive) {
  Summary summary;
  summary.seed = 18446744073709551615U;
  summary.penetrations = 0;
  summary.reached_fraction = 0.1;
  summary.fields = FieldsSummary{0, Spread{0.2, 0.3, 0.4}, std::nullopt, 2};
  const auto json = Json::parse(to_json(summary));
  EXPECT_EQ(json["seed"].get<std::uint64_t>(), 18446744073709551615U);
  EXPECT_EQ(json["penetrations"], 0);
  EXPECT_EQ(json["reached_fraction"].get<double>(), 0.1);
  EXPECT_EQ(json["fields"]["updates"], 0);
  EXPECT_EQ(json["fields"]["age_s"]["p99"], 0.3);
  EXPECT_TRUE(json["fields"]["solve_s"]["p50"].is_null());
  EXPECT_EQ(json["fields"]["unreachable"], 2);
}

}  // namespace
}  // namespace mayfly::record
