// Interaction zones (BSwarm15 Eq. 4, Ren16; model.md §5): repulsion, alignment and attraction, each a mean
// over the neighbours in its zone.
#ifndef MAYFLY_KERNELS_ZONES_H
#define MAYFLY_KERNELS_ZONES_H

#include "kernels/far.h"
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
    const F inverse = mf_kept(within, mf_inverse_root(squared));
    sum = mf3_add(sum, mf3_scale(line, inverse));
    count -= within;
  }
  sums->att = mf3_add(sums->att, sum);
  sums->att_count += count;
}

// Neighbours that may be in any zone. `aligning` and `attracting` are literals at each call: whether those
// zones count.
MF_FN void mf_add_near(MfZoneSums* sums, const MfZoneSearch* search, const MfNeighbours* n, int first,
                       int past, int aligning, int attracting) {
  const F rep_squared = search->rep_squared, ali_squared = search->ali_squared;
  F3 rep = mf_zero3(), ali = mf_zero3(), att = mf_zero3();
  I rep_count = mf_isplat(0), ali_count = mf_isplat(0), att_count = mf_isplat(0);
  for (int j = first; j < past; ++j) {
    const F3 line = mf3_sub(mf3_splat(n->x[j], n->y[j], n->z[j]), search->r);
    const F squared = mf3_dot(line, line);
    const I in_rep = squared < rep_squared;
    const I beyond = squared >= ali_squared;
    const F inverse = mf_quick_inverse(squared);
    rep = mf3_add(rep, mf3_scale(line, mf_kept(in_rep, inverse)));
    rep_count -= in_rep;
    if (attracting) {
      const I in_att = beyond & (squared <= search->att_squared);
      att = mf3_add(att, mf3_scale(line, mf_kept(in_att, inverse)));
      att_count -= in_att;
    }
    if (aligning) {
      const F3 faster = mf3_sub(mf3_splat(n->vx[j], n->vy[j], n->vz[j]), search->v);
      const I in_ali = ~(in_rep | beyond);
      const F per_speed = mf_quick_inverse(mf3_dot(faster, faster));
      ali = mf3_add(ali, mf3_scale(faster, mf_kept(in_ali, per_speed)));
      ali_count -= in_ali;
    }
  }
  sums->rep = mf3_add(sums->rep, rep);
  sums->ali = mf3_add(sums->ali, ali);
  sums->att = mf3_add(sums->att, att);
  sums->rep_count += rep_count;
  sums->ali_count += ali_count;
  sums->att_count += att_count;
}

// One row of cells: within the alignment zone's reach all zones are asked for, further out attraction alone.
MF_FN void mf_add_row(MfZoneSums* sums, const MfZoneSearch* search, const MfNeighbours* n,
                      const MF_GLOBAL int* row, const MfRows* outer, const MfRows* inner, int k, int aligning,
                      int attracting) {
  const int first = row[outer->first[k]];
  const int past = row[outer->past[k]];
  if (first == past) return;
  if (!attracting) {
    mf_add_near(sums, search, n, first, past, aligning, 0);
    return;
  }
  const int nobody = inner->first[k] == inner->past[k];
  const int near_first = nobody ? past : row[inner->first[k]];
  const int near_past = nobody ? past : row[inner->past[k]];
  mf_add_far(sums, search, n, first, near_first);
  mf_add_near(sums, search, n, near_first, near_past, aligning, 1);
  mf_add_far(sums, search, n, near_past, past);
}

// What all neighbours of eight agents come to, in an order of its own for each agent: that of the sorted. `n`
// holds nobody but the swarm. Zones that `aligning` and `attracting` (literals at each call) leave out stay
// empty.
MF_FN MfZoneSums mf_zone_sums(const MfZoneSearch* search, const MfForces* zones, const MfCubes* c,
                              const MfNeighbours* n, int aligning, int attracting) {
  MfZoneSums sums;
  sums.rep = sums.ali = sums.att = mf_zero3();
  sums.rep_count = sums.ali_count = sums.att_count = mf_isplat(0);
  // Each agent comes upon itself, in the innermost zone there is: a zero vector, but one too many.
  if (zones->rep_radius > 0.0f) {
    sums.rep_count -= 1;
  } else if (zones->ali_radius > 0.0f) {
    sums.ali_count -= 1;
  } else {
    sums.att_count -= 1;
  }
  const float radius = aligning ? zones->ali_radius : zones->rep_radius;
  const float inner_reach = zones->ali_radius * c->inverse;
  const float reach = (attracting ? zones->att_radius : radius) * c->inverse;
  const MfBox box = mf_box_around(search->r, c);
  const int y_first = mf_first_cube(box.low_y, reach, c->cells_y);
  const int y_last = mf_last_cube(box.high_y, reach, c->cells_y);
  const int z_last = mf_last_cube(box.high_z, reach, c->cells_z);
  for (int z = mf_first_cube(box.low_z, reach, c->cells_z); z <= z_last; ++z) {
    for (int y = y_first; y <= y_last; y += MF_LANES) {
      const MfRows outer = mf_rows(&box, y, z, reach, c);
      const MfRows inner = attracting ? mf_rows(&box, y, z, inner_reach, c) : outer;
      const MF_GLOBAL int* row = n->start + (z * c->cells_y + y) * c->cells_x;
      for (int k = 0; k < MF_LANES && y + k <= y_last; ++k, row += c->cells_x) {
        mf_add_row(&sums, search, n, row, &outer, &inner, k, aligning, attracting);
      }
    }
  }
  return sums;
}

// χ/N Σ, and 0 for an empty zone. Of a mesh, less than half a neighbour is nobody.
MF_FN F3 mf_zone_mean(F3 sum, F count, float weight) {
  const I somebody = count >= mf_splat(0.5f);
  return mf3_scale(mf3_kept(somebody, sum), weight / mf_max(count, mf_splat(1.0f)));
}

// F_int, m/s².
MF_FN F3 mf_zone_force(const MfZoneSums* sums, F3 att, F att_count, const MfForces* zones) {
  const F3 rep = mf_zone_mean(sums->rep, mf_to_float(sums->rep_count), -zones->rep_weight);
  const F3 ali = mf_zone_mean(sums->ali, mf_to_float(sums->ali_count), zones->ali_weight);
  return mf3_add(mf3_add(rep, ali), mf_zone_mean(att, att_count, zones->att_weight));
}

MF_END

#endif
