#include "controller/governor/reference.hpp"

#include <algorithm>
#include <cmath>

namespace mayfly {

Reference::Reference(int latency)
    : leads_(static_cast<std::size_t>(latency)), bodies_(static_cast<std::size_t>(latency)) {}

void Reference::adopt(glm::dvec3 place, glm::vec3 velocity, const ReferenceModel& model) noexcept {
  body_ = place;
  lead_ = place + model.response_time * glm::dvec3(velocity);
  velocity_ = glm::dvec3(velocity);
  known_ = true;
  std::fill(leads_.begin(), leads_.end(), lead_);
  std::fill(bodies_.begin(), bodies_.end(), body_);
}

void Reference::advance(glm::vec3 command, double time, const ReferenceModel& model) noexcept {
  for (std::vector<glm::dvec3>* past : {&leads_, &bodies_}) {
    std::copy(past->begin() + (past->empty() ? 0 : 1), past->end(), past->begin());
  }
  if (!leads_.empty()) {
    leads_.back() = lead_;
    bodies_.back() = body_;
  }
  const glm::dvec3 w(command);
  if (model.response_time > 0.0) {
    const double left = std::exp(-time / model.response_time);
    const glm::dvec3 behind = model.response_time * w;
    const glm::dvec3 ahead = behind + left * ((lead_ - body_) - behind);
    lead_ += time * w;
    body_ = lead_ - ahead;
    velocity_ = w;
    return;
  }
  const glm::dvec3 change = w - velocity_;
  const double needs = length3(change) / model.acceleration;
  const glm::dvec3 made = needs > time ? change * (time / needs) : change;
  velocity_ = needs > time ? velocity_ + made : w;
  lead_ += time * velocity_ - 0.5 * std::min(needs, time) * made;
  body_ = lead_;
}

void Reference::shift(glm::dvec3 way) noexcept {
  lead_ += way;
  body_ += way;
  for (std::vector<glm::dvec3>* past : {&leads_, &bodies_}) {
    for (glm::dvec3& place : *past) {
      place += way;
    }
  }
}

glm::dvec3 Reference::way_to(glm::dvec3 place) const noexcept {
  const Capsule point{place, place, 0.0};
  glm::dvec3 shortest = place - body_;
  for (std::size_t n = 0; n < bodies_.size(); ++n) {
    const glm::dvec3 next = n + 1 < bodies_.size() ? bodies_[n + 1] : body_;
    const glm::dvec3 way = nearest_way(point, {bodies_[n], next, 0.0});
    if (dot3(way, way) < dot3(shortest, shortest)) {
      shortest = way;
    }
  }
  return shortest;
}

void Reference::add_tail(Hull& hull, const ReferenceModel& model) const noexcept {
  if (model.response_time > 0.0) {
    hull.add(bodies_.empty() ? body_ : bodies_.front());
  }
  for (const glm::dvec3& lead : leads_) {
    hull.add(lead);
  }
}

double Reference::tail_reach(const ReferenceModel& model) const noexcept {
  Hull tail;
  add_tail(tail, model);
  double farthest = 0.0;
  for (const glm::dvec3& place : tail.points()) {
    farthest = std::max(farthest, length3(place - lead_));
  }
  return farthest;
}

}  // namespace mayfly
