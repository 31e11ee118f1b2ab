// Attraction from afar: a swarm's cells act as lumps on the nodes of a mesh, and agents read the mesh between
// its nodes. Attraction is a mean over a wide shell, so that lumps much smaller than the shell do; the zones
// inside the shell, where single neighbours matter, know nothing of the mesh.
#ifndef MAYFLY_KERNELS_FAR_H
#define MAYFLY_KERNELS_FAR_H

#include "kernels/neighbours.h"

MF_BEGIN

// Cubes, one lump each; nodes are their corners.
typedef struct {
  MfCubes cubes;
  int on;
  float ali_radius, att_radius;  // m
} MfMesh;

// Lumps in the order of their cubes (start[c]: the first one of cube c), and behind them the agents that no
// cube holds; mass in agents.
typedef struct {
  const MF_GLOBAL int* start;
  const MF_GLOBAL float *x, *y, *z, *mass;
  int strays;  // how many there are behind those of the cubes
} MfLumps;

// Σ r̂ and the number of neighbours between ali_radius and att_radius. A lump on an edge counts by the part
// of its cube that is within, as if the edge were a plane.
typedef struct {
  F3 sum;
  F count;
} MfFar;

MF_FN void mf_add_lumps(MfFar* far, F3 node, const MfLumps* l, int first, int past, const MfMesh* mesh) {
  const float per_cube = mesh->cubes.inverse;
  const float outer = mesh->att_radius * per_cube + 0.5f;
  const float inner = mesh->ali_radius > 0.0f ? 0.5f - mesh->ali_radius * per_cube : 1.0f;
  F3 sum = mf3_splat(0.0f, 0.0f, 0.0f);
  F count = mf_splat(0.0f);
  for (int k = first; k < past; ++k) {
    const F3 line = mf3_sub(mf3_splat(l->x[k], l->y[k], l->z[k]), node);
    const F squared = mf3_dot(line, line);
    const F inverse = mf_quick_inverse(squared);
    const F cubes = squared * inverse * per_cube;
    const F within = mf_clamp(mf_min(outer - cubes, cubes + inner), 0.0f, 1.0f);
    const F weight = within * l->mass[k];
    sum = mf3_add(sum, mf3_scale(line, inverse * weight));
    count += weight;
  }
  far->sum = mf3_add(far->sum, sum);
  far->count += count;
}

// What all lumps do to eight nodes.
MF_FN MfFar mf_far_at(F3 node, const MfLumps* l, const MfMesh* mesh) {
  const MfCubes* c = &mesh->cubes;
  MfFar far;
  far.sum = mf3_splat(0.0f, 0.0f, 0.0f);
  far.count = mf_splat(0.0f);
  const float reach = mesh->att_radius * c->inverse + 0.5f;
  const MfBox box = mf_box_around(node, c);
  const int y_first = mf_first_cube(box.low_y, reach, c->cells_y);
  const int y_last = mf_last_cube(box.high_y, reach, c->cells_y);
  const int z_last = mf_last_cube(box.high_z, reach, c->cells_z);
  for (int z = mf_first_cube(box.low_z, reach, c->cells_z); z <= z_last; ++z) {
    for (int y = y_first; y <= y_last; y += MF_LANES) {
      const MfRows rows = mf_rows(&box, y, z, reach, c);
      const MF_GLOBAL int* row = l->start + (z * c->cells_y + y) * c->cells_x;
      for (int k = 0; k < MF_LANES && y + k <= y_last; ++k, row += c->cells_x) {
        mf_add_lumps(&far, node, l, row[rows.first[k]], row[rows.past[k]], mesh);
      }
    }
  }
  const int lumps = l->start[c->cells_x * c->cells_y * c->cells_z];
  mf_add_lumps(&far, node, l, lumps, lumps + l->strays, mesh);
  return far;
}

// In cubes from the corner; whoever is not among them reads no mesh.
MF_FN F3 mf_in_mesh(F3 r, const MfCubes* c) {
  return mf3(mf_in_cells(r.x, c->low_x, c->inverse), mf_in_cells(r.y, c->low_y, c->inverse),
             mf_in_cells(r.z, c->low_z, c->inverse));
}
MF_FN I mf_within_mesh(F3 u, const MfCubes* c) {
  const F zero = mf_splat(0.0f);
  return (u.x >= zero) & (u.y >= zero) & (u.z >= zero) & (u.x <= mf_splat((float)c->cells_x)) &
         (u.y <= mf_splat((float)c->cells_y)) & (u.z <= mf_splat((float)c->cells_z));
}

// Between the nodes, linearly. `nodes` has four floats each, x fastest.
MF_FN MfFar mf_far_between(F3 u, const MF_GLOBAL float* nodes, const MfCubes* c) {
  const I ix = mf_cube_along(u.x, c->cells_x);
  const I iy = mf_cube_along(u.y, c->cells_y);
  const I iz = mf_cube_along(u.z, c->cells_z);
  const F3 t = mf3(u.x - mf_to_float(ix), u.y - mf_to_float(iy), u.z - mf_to_float(iz));
  const int row = c->cells_x + 1;
  const I first = (iz * (c->cells_y + 1) + iy) * row + ix;
  MfFar far;
  far.sum = mf3_splat(0.0f, 0.0f, 0.0f);
  far.count = mf_splat(0.0f);
  for (int corner = 0; corner < 8; ++corner) {
    const int x = corner & 1, y = (corner >> 1) & 1, z = corner >> 2;
    F node[4];
    mf_gather4(nodes, (first + ((z * (c->cells_y + 1) + y) * row + x)) * 4, node);
    const F weight = (x ? t.x : 1.0f - t.x) * (y ? t.y : 1.0f - t.y) * (z ? t.z : 1.0f - t.z);
    far.sum = mf3_add(far.sum, mf3_scale(mf3(node[0], node[1], node[2]), weight));
    far.count += node[3] * weight;
  }
  return far;
}

MF_END

#endif
