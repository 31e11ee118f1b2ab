// What a swarm minds besides itself: predators, prey, mates and lamps (BSwarm15 §4, F_res; model.md §5).
#ifndef MAYFLY_KERNELS_STIMULUS_H
#define MAYFLY_KERNELS_STIMULUS_H

#include "kernels/draw.h"

MF_BEGIN

#define MF_MAX_STIMULI 8

#define MF_STIMULUS_PREY 0      // food, a mate, a lamp: straight to it
#define MF_STIMULUS_PREDATOR 1  // away from it, turned about the vertical by an angle drawn once an encounter
#define MF_STIMULUS_AHEAD 2     // each agent's own, `distance` ahead of it and `turn` to the left (bats)

typedef struct {
  int kind;
  float x, y, z;   // m, now
  float weight;    // m/s², χ_res
  float reach;     // m, r_res
  float distance;  // m, MF_STIMULUS_AHEAD only
  float turn;      // rad, MF_STIMULUS_AHEAD only: about +z, from the agent's heading
} MfStimulus;

// u turned about +z, `turns` in whole turns.
MF_FN F3 mf_turned(F3 u, F turns) {
  const F part = turns - mf_to_float(mf_floor(turns));
  const F beyond = part + 0.25f;
  const F sine = mf_sin_turns(part);
  const F cosine = mf_sin_turns(mf_select(beyond > mf_splat(1.0f), beyond - 1.0f, beyond));
  return mf3(cosine * u.x - sine * u.y, sine * u.x + cosine * u.y, u.z);
}

// An agent's encounters with a predator: twice their number, and one more while it is within reach.
MF_FN I mf_after_encounter(I before, I within) {
  const I entered = within & ((before & 1) == 0);
  const I counted = mf_iselect(entered, before + 3, before);
  return mf_iselect(within, counted, before & ~1);
}

// θ of an encounter in turns: uniform in [−1/4, 0], a function of the key, the agent, the predator and the
// encounter.
MF_FN F mf_flight_turns(const MfMoment* key, I id, I encounters, uint predator) {
  const U word = mf_draw(key, id, MF_STREAM_ENCOUNTER + predator);
  return mf_unit_interval(mf_mix(word + mf_to_unsigned(encounters) * 0x9e3779b9u)) * -0.25f;
}

// F_res of one stimulus on agents at r (m) that fly at v (m/s), m/s². `turns` is θ of their encounter.
MF_FN F3 mf_stimulus_force(F3 r, F3 v, const MfStimulus* s, F turns) {
  if (s->kind == MF_STIMULUS_AHEAD) {
    const F angle = mf_splat(s->turn * 0.159154943f);
    return mf3_scale(mf_turned(mf3_unit(v), angle), mf_splat(s->distance <= s->reach ? s->weight : 0.0f));
  }
  const F3 line = mf3_sub(r, mf3_splat(s->x, s->y, s->z));
  const I felt = mf3_dot(line, line) <= mf_splat(s->reach * s->reach);
  if (!mf_any(felt)) return mf3_splat(0.0f, 0.0f, 0.0f);
  const F3 away = mf3_unit(line);
  const F3 direction =
      s->kind == MF_STIMULUS_PREDATOR ? mf_turned(away, turns) : mf3_scale(away, mf_splat(-1.0f));
  return mf3_select(felt, mf3_scale(direction, mf_splat(s->weight)), mf3_splat(0.0f, 0.0f, 0.0f));
}

// The sum of all stimuli. `encounters` is one column of `agents` elements a stimulus, of which this brings
// those of the first `lanes` of the agents up to date; `agent` is their index in the swarm.
MF_FN F3 mf_stimuli_force(F3 r, F3 v, I id, I agent, int lanes, const MfStimulus* stimulus, int stimuli,
                          const MfMoment* key, MF_GLOBAL int* encounters, int agents) {
  F3 force = mf3_splat(0.0f, 0.0f, 0.0f);
  for (int k = 0; k < stimuli; ++k) {
    const MfStimulus* s = &stimulus[k];
    F turns = mf_splat(0.0f);
    if (s->kind == MF_STIMULUS_PREDATOR) {
      MF_GLOBAL int* column = encounters + k * agents;
      const F3 line = mf3_sub(r, mf3_splat(s->x, s->y, s->z));
      const I within = mf3_dot(line, line) <= mf_splat(s->reach * s->reach);
      const I now = mf_after_encounter(mf_igather(column, agent), within);
      mf_iscatter(column, agent, now, lanes);
      turns = mf_flight_turns(key, id, now >> 1, (uint)k);
    }
    force = mf3_add(force, mf_stimulus_force(r, v, s, turns));
  }
  return force;
}

MF_END

#endif
