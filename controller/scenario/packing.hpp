// How many agents a start region has room for, when no two may be nearer than a separation.
#pragma once

namespace mayfly {

// Share of space that spheres fill at best when they lie as they fell (random close packing). Kepler's bound,
// 0.740, is for a perfect crystal, which no start is.
inline constexpr double kRandomClosePacking = 0.64;
// Above this share, spheres that are put down one by one, each at random, find no place any more (random
// sequential addition): a start this dense takes long to find.
inline constexpr double kRandomAddition = 0.38;

// Of a region whose centres may lie in a volume: that volume, grown by half a separation on every side (m³),
// since the spheres around the centres may stick out.
double grown_box_volume(double x, double y, double z, double separation);
double grown_sphere_volume(double radius, double separation);

// Share of the grown volume that `count` spheres of diameter `separation` fill.
double packed_share(double count, double separation, double grown_volume);

// How many such spheres fill a share of the grown volume; at least 1, since one agent always fits.
double count_that_fits(double separation, double grown_volume, double share);

}  // namespace mayfly
