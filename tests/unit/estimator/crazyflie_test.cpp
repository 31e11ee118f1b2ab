// Real flights of a Crazyflie 2.1, as its motion capture and its own log saw them
// ($MAYFLY_DATA/crazyflie_lee).
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "tests/unit/estimator/rig.hpp"

namespace mayfly::estimator_test {
namespace {

struct Row {
  Time stamp;
  Vec place, velocity, told;
};

std::vector<Row> rows_of(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);  // names
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    double t = 0.0, skipped = 0.0;
    Row row{};
    fields >> t >> row.place[0] >> row.place[1] >> row.place[2];
    fields >> row.velocity[0] >> row.velocity[1] >> row.velocity[2] >> skipped >> skipped >> skipped;
    fields >> row.told[0] >> row.told[1] >> row.told[2];
    row.stamp = std::chrono::seconds(1) + from_seconds(t);
    rows.push_back(row);
  }
  return rows;
}

double distance(const Vec& a, const Vec& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// Root mean squares against the log.
struct Errors {
  double place = 0.0, velocity = 0.0, sample = 0.0;
  int alarms = 0, unknown = 0;
};

class Crazyflie : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const char* data = std::getenv("MAYFLY_DATA");
    const std::string path =
        std::string(data == nullptr ? "" : data) + "/crazyflie_lee/" + GetParam() + ".csv";
    if (data == nullptr || !std::filesystem::exists(path)) {
      GTEST_SKIP() << "no " << GetParam() << ".csv in $MAYFLY_DATA/crazyflie_lee";
    }
    rows_ = rows_of(path);
    ASSERT_GT(rows_.size(), 1000U);
  }
  // Every nth row is a pose, with noise beside that which the configuration knows of: the log's rows repeat a
  // pose until the next comes, after 8 ms. Velocities are left to the filter. There are gaps of up to 76 ms.
  Errors fly(std::size_t every, double known_noise, double noise) const {
    EstimatorConfig config = config_of(1, static_cast<float>(known_noise));
    config.period = std::chrono::milliseconds(4);
    config.most_age = std::chrono::milliseconds(100);
    config.sources[0].takes_velocity = false;
    config.sources[0].resolution = 0.001F;
    config.robots[0] = {3.0F, 10.0F, 0.05F};
    Rig rig(config);
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    Errors errors;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      rig.now = rows_[i].stamp;
      Vec seen = rows_[i].place;
      for (double& coordinate : seen) {
        coordinate += noise * normal(random);
      }
      if (i % every == 0) {
        rig.put(0, seen);
      }
      rig.tell(0, rows_[i].told);
      rig.tick();
      errors.alarms += rig.estimator.estimate().symptoms[0].empty() ? 0 : 1;
      errors.unknown += rig.known(0) ? 0 : 1;
      errors.place += std::pow(distance(rig.place(0), rows_[i].place), 2);
      errors.velocity += i < 50 ? 0.0 : std::pow(distance(rig.velocity(0), rows_[i].velocity), 2);
      errors.sample += std::pow(distance(seen, rows_[i].place), 2);
    }
    const auto count = static_cast<double>(rows_.size());
    errors.place = std::sqrt(errors.place / count);
    errors.velocity = std::sqrt(errors.velocity / (count - 50));
    errors.sample = std::sqrt(errors.sample / count);
    RecordProperty("place_error_mm", std::to_string(1e3 * errors.place));
    RecordProperty("velocity_error_mm_s", std::to_string(1e3 * errors.velocity));
    return errors;
  }

  std::vector<Row> rows_;
};

TEST_P(Crazyflie, RaisesNoAlarmAndKnowsWhereItIs) {
  const Errors errors = fly(1, 0.003, 0.0);
  EXPECT_EQ(errors.alarms, 0);
  EXPECT_EQ(errors.unknown, 0);
  // The log's own velocity differs from its places' differences by up to 0.08 m/s.
  EXPECT_LT(errors.place, 0.003);
  EXPECT_LT(errors.velocity, 0.14);
}

TEST_P(Crazyflie, AtAThirdOfTheRate) {
  const Errors errors = fly(3, 0.003, 0.0);
  EXPECT_EQ(errors.alarms, 0);
  EXPECT_LT(errors.place, 0.004);
  EXPECT_LT(errors.velocity, 0.14);
}

TEST_P(Crazyflie, ThroughNoiseItIsNearerThanTheSamples) {
  const Errors errors = fly(1, 0.01, 0.01);
  EXPECT_EQ(errors.alarms, 0);
  EXPECT_LT(errors.place, 0.75 * errors.sample);
  EXPECT_LT(errors.velocity, 0.20);
}

INSTANTIATE_TEST_SUITE_P(Logs, Crazyflie,
                         ::testing::Values("log148", "log178", "log201", "log202", "log204"));

}  // namespace
}  // namespace mayfly::estimator_test
