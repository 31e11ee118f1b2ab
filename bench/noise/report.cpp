#include "bench/noise/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace mayfly::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kColumn = 11;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json variant_json(const VariantResult& variant) {
  Json json{{"model", name_of(variant.model)}, {"noise", name_of(variant.noise)}};
  for (const MeasureInfo& info : kMeasures) {
    json[std::string(info.key)] = {{"mean", number(variant.mean(info.member))},
                                   {"least", number(variant.least(info.member))},
                                   {"most", number(variant.most(info.member))}};
  }
  return json;
}

}  // namespace

std::string to_text(const NoiseComparison& comparison) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(
      out,
      "Noises compared (Wang14, section 7.1): two blocks, {} agents, {:g} s, {} seeds, no MDE; {:.0f} s\n\n",
      comparison.plan.agents, comparison.plan.duration_s, comparison.plan.seeds, comparison.took_s);
  fmt::format_to(out, "{:<15}", "model noise");
  for (const MeasureInfo& info : kMeasures) {
    fmt::format_to(out, "{:>{}}", info.title, kColumn);
  }
  text += '\n';
  for (const VariantResult& variant : comparison.variants) {
    fmt::format_to(out, "{:<6}{:<9}", name_of(variant.model), name_of(variant.noise));
    for (const MeasureInfo& info : kMeasures) {
      fmt::format_to(out, "{:>{}.{}f}", variant.mean(info.member), kColumn, info.digits);
    }
    text += '\n';
  }
  text += '\n';
  for (const Verdict& verdict : comparison.verdicts) {
    fmt::format_to(out, "{:<8} {}: {:.3g} (wanted {} {:g})\n", verdict.holds() ? "holds" : "DOES NOT",
                   verdict.claim, verdict.value, verdict.at_least ? ">=" : "<=", verdict.bound);
  }
  return text;
}

std::string to_json(const NoiseComparison& comparison) {
  Json json{{"bench", "noise"},
            {"agents", comparison.plan.agents},
            {"duration_s", comparison.plan.duration_s},
            {"seeds", comparison.plan.seeds},
            {"took_s", number(comparison.took_s)},
            {"variants", Json::array()},
            {"verdicts", Json::array()}};
  for (const VariantResult& variant : comparison.variants) {
    json["variants"].push_back(variant_json(variant));
  }
  for (const Verdict& verdict : comparison.verdicts) {
    json["verdicts"].push_back({{"claim", verdict.claim},
                                {"value", number(verdict.value)},
                                {"comparison", verdict.at_least ? ">=" : "<="},
                                {"bound", verdict.bound},
                                {"holds", verdict.holds()}});
  }
  return json.dump(2) + '\n';
}

}  // namespace mayfly::bench
