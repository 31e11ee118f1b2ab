// What an agent of the force model is driven by (BSwarm15 §4, Ren16; model.md §5). Plain numbers: they travel
// to a kernel as an argument.
#ifndef MAYFLY_KERNELS_FORCES_H
#define MAYFLY_KERNELS_FORCES_H

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

// Zones are radii, not differences: 0 <= rep <= ali <= att, m. Weights χ in m/s². Noise is a force.
typedef struct {
  float friction;  // 1/m, γ
  float rep_weight, ali_weight, att_weight;
  float rep_radius, ali_radius, att_radius;
  int stimuli;
  MfStimulus stimulus[MF_MAX_STIMULI];
} MfForces;

// Reynolds 1987: weights in 1/s² (separation: m/s²) and radii in m. Kept at `speed` m/s.
typedef struct {
  float separation_weight, alignment_weight, cohesion_weight;
  float separation_radius, alignment_radius, cohesion_radius;
  float speed;
} MfBoids;

// Schweitzer 1998: active Brownian particles with an energy depot in its stationary state, in a parabolic
// potential about a centre.
typedef struct {
  float friction;                         // 1/s, γ0
  float intake, dissipation, conversion;  // m²/s³ q, 1/s c, s/m² d: the depot drives with d q / (c + d v²)
  float noise;                            // m/s^1.5, √(2D)
  float pull;                             // 1/s², a
  float x, y, z;                          // m, the centre
} MfBrownian;

// Optimal reciprocal collision avoidance in three dimensions (van den Berg et al. 2011).
typedef struct {
  int on;
  float radius;        // m, of the body, margins included
  float horizon;       // s, against agents
  float wall_horizon;  // s, against obstacles
  float range;         // m, nobody farther is considered
  int neighbours;      // the nearest so many are, at most MF_MAX_NEIGHBOURS
  float most_speed;    // m/s
  int strict;          // 1: no two of them touch even in a jam, where both are strict; it slows a dense flock
} MfAvoidance;

#define MF_MAX_NEIGHBOURS 16

MF_END

#endif
