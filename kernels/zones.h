// Interaction zones (BSwarm15 Eq. 4, Ren16; model.md §5): repulsion, alignment and attraction, each a mean
// over the neighbours in its zone.
#ifndef MAYFLY_KERNELS_ZONES_H
#define MAYFLY_KERNELS_ZONES_H

#include "kernels/neighbours.h"
#include "kernels/stimulus.h"

MF_BEGIN

// What an agent of the force model is driven by. Zones are radii, not differences: 0 <= rep <= ali <= att, m.
// Weights χ in m/s². Noise, which is a force here, stands in MfField.
typedef struct {
  float friction;  // 1/m, γ
  float rep_weight, ali_weight, att_weight;
  float rep_radius, ali_radius, att_radius;
  int stimuli;
  MfStimulus stimulus[MF_MAX_STIMULI];
} MfForces;

// Sums of unit vectors over the neighbours in each zone, and how many these are.
typedef struct {
  F3 rep, ali, att;
  I rep_count, ali_count, att_count;
} MfZoneSums;

// The same for all of eight agents' search.
typedef struct {
  F rep_squared, ali_squared, att_squared;  // m²
  F3 r, v;                                  // m, m/s
  I slot;                                   // the agents' own places among the sorted
} MfZoneSearch;

MF_FN F3 mf_zero3(void) {
  return mf3_splat(0.0f, 0.0f, 0.0f);
}

// Neighbours first … past − 1, who are all further off than the alignment zone and than 1e-9 m.
MF_FN void mf_add_far(MfZoneSums* sums, const MfZoneSearch* search, const MfNeighbours* n, int first,
                      int past) {
  F3 sum = mf_zero3();
  I count = mf_isplat(0);
  const F3 r = search->r;
  const F most = search->att_squared;
  for (int j = first; j < past; ++j) {
    const F3 line = mf3_sub(mf3_splat(n->x[j], n->y[j], n->z[j]), r);
    const F squared = mf3_dot(line, line);
    const I within = squared <= most;
    const F inverse = mf_select(within, mf_inverse_root(squared), mf_splat(0.0f));
    sum = mf3_add(sum, mf3_scale(line, inverse));
    count -= within;
  }
  sums->att = mf3_add(sums->att, sum);
  sums->att_count += count;
}

// Neighbours that may be in any zone. `aligning` is a literal at each call: whether the middle zone counts.
MF_FN void mf_add_near(MfZoneSums* sums, const MfZoneSearch* search, const MfNeighbours* n, int first,
                       int past, int aligning) {
  const F zero = mf_splat(0.0f);
  F3 rep = mf_zero3(), att = mf_zero3();
  for (int j = first; j < past; ++j) {
    const F3 line = mf3_sub(mf3_splat(n->x[j], n->y[j], n->z[j]), search->r);
    const F squared = mf3_dot(line, line);
    const I other = search->slot != mf_isplat(j);
    const I in_rep = (squared < search->rep_squared) & other;
    const I in_att = (squared >= search->ali_squared) & (squared <= search->att_squared) & other;
    const F3 unit = mf_quick_unit(line, squared);
    rep = mf3_add(rep, mf3_select(in_rep, unit, mf_zero3()));
    att = mf3_add(att, mf3_select(in_att, unit, mf_zero3()));
    sums->rep_count -= in_rep;
    sums->att_count -= in_att;
    if (aligning) {
      const I in_ali = (squared >= search->rep_squared) & (squared < search->ali_squared) & other;
      if (!mf_any(in_ali)) continue;
      const F3 faster = mf3_sub(mf3_splat(n->vx[j], n->vy[j], n->vz[j]), search->v);
      const F speed = mf_select(in_ali, mf3_dot(faster, faster), zero);
      sums->ali = mf3_add(sums->ali, mf3_select(in_ali, mf_quick_unit(faster, speed), mf_zero3()));
      sums->ali_count -= in_ali;
    }
  }
  sums->rep = mf3_add(sums->rep, rep);
  sums->att = mf3_add(sums->att, att);
}

// One row of cells: within the alignment zone's reach all zones are asked for, further out attraction alone.
MF_FN void mf_add_row(MfZoneSums* sums, const MfZoneSearch* search, const MfNeighbours* n,
                      const MF_GLOBAL int* row, const MfRows* outer, const MfRows* inner, int k,
                      int aligning) {
  const int first = row[outer->first[k]];
  const int past = row[outer->past[k]];
  if (first == past) return;
  const int nobody = inner->first[k] == inner->past[k];
  const int near_first = nobody ? past : row[inner->first[k]];
  const int near_past = nobody ? past : row[inner->past[k]];
  mf_add_far(sums, search, n, first, near_first);
  mf_add_near(sums, search, n, near_first, near_past, aligning);
  mf_add_far(sums, search, n, near_past, past);
}

// What all neighbours of eight agents come to, in an order of its own for each agent: that of the sorted. `n`
// holds nobody but the swarm. Of zones without a weight the sums may be left out.
MF_FN MfZoneSums mf_zone_sums(const MfZoneSearch* search, const MfForces* zones, const MfCubes* c,
                              const MfNeighbours* n, int aligning) {
  MfZoneSums sums;
  sums.rep = sums.ali = sums.att = mf_zero3();
  sums.rep_count = sums.ali_count = sums.att_count = mf_isplat(0);
  const int attracts = zones->att_weight != 0.0f && zones->att_radius > 0.0f;
  const float near_reach = (aligning ? zones->ali_radius : zones->rep_radius) * c->inverse;
  const float inner_reach = zones->ali_radius * c->inverse;
  const float reach = attracts ? zones->att_radius * c->inverse : near_reach;
  const MfBox box = mf_box_around(search->r, c);
  const int y_first = mf_first_cube(box.low_y, reach, c->cells_y);
  const int y_last = mf_last_cube(box.high_y, reach, c->cells_y);
  const int z_last = mf_last_cube(box.high_z, reach, c->cells_z);
  for (int z = mf_first_cube(box.low_z, reach, c->cells_z); z <= z_last; ++z) {
    for (int y = y_first; y <= y_last; y += MF_LANES) {
      const MfRows outer = mf_rows(&box, y, z, reach, c);
      const MfRows inner = attracts ? mf_rows(&box, y, z, inner_reach, c) : outer;
      const MF_GLOBAL int* row = n->start + (z * c->cells_y + y) * c->cells_x;
      for (int k = 0; k < MF_LANES && y + k <= y_last; ++k) {
        mf_add_row(&sums, search, n, row + k * c->cells_x, &outer, &inner, k, aligning);
      }
    }
  }
  return sums;
}

// χ/N Σ, and 0 for an empty zone.
MF_FN F3 mf_zone_mean(F3 sum, I count, float weight) {
  const F all = mf_to_float(mf_imax(count, mf_isplat(1)));
  return mf3_scale(sum, weight / all);
}

// F_int, m/s².
MF_FN F3 mf_zone_force(const MfZoneSums* sums, const MfForces* zones) {
  const F3 rep = mf_zone_mean(sums->rep, sums->rep_count, -zones->rep_weight);
  const F3 ali = mf_zone_mean(sums->ali, sums->ali_count, zones->ali_weight);
  const F3 att = mf_zone_mean(sums->att, sums->att_count, zones->att_weight);
  return mf3_add(mf3_add(rep, ali), att);
}

MF_END

#endif
