// Eight doubles at once, and the few operations that distance queries need. A query is written once, on T,
// and runs for one point (T = double) or for eight neighbouring cells (T = Double8).
#pragma once

#include <cmath>

namespace mayfly::fields {

// Two halves of four: compilers split wider vectors badly where the processor has no 512-bit registers.
using Double4 = double __attribute__((vector_size(32)));
using Mask4 = decltype(Double4{} < Double4{});

struct Mask8 {
  Mask4 low, high;
};
struct Double8 {
  Double4 low, high;

  double operator[](int lane) const { return lane < 4 ? low[lane] : high[lane - 4]; }
  void set(int lane, double value) {
    if (lane < 4) {
      low[lane] = value;
    } else {
      high[lane - 4] = value;
    }
  }
};

inline Double4 splat4(double a) {
  return Double4{a, a, a, a};
}

template <class T>
T splat(double a);
template <>
inline double splat<double>(double a) {
  return a;
}
template <>
inline Double8 splat<Double8>(double a) {
  return {splat4(a), splat4(a)};
}

inline Double8 operator+(Double8 a, Double8 b) {
  return {a.low + b.low, a.high + b.high};
}
inline Double8 operator-(Double8 a, Double8 b) {
  return {a.low - b.low, a.high - b.high};
}
inline Double8 operator*(Double8 a, Double8 b) {
  return {a.low * b.low, a.high * b.high};
}
inline Double8 operator+(Double8 a, double b) {
  return {a.low + b, a.high + b};
}
inline Double8 operator-(Double8 a, double b) {
  return {a.low - b, a.high - b};
}
inline Double8 operator-(double a, Double8 b) {
  return {a - b.low, a - b.high};
}
inline Double8 operator*(Double8 a, double b) {
  return {a.low * b, a.high * b};
}
inline Mask8 operator<(Double8 a, Double8 b) {
  return {a.low < b.low, a.high < b.high};
}
inline Mask8 operator>=(Double8 a, double b) {
  return {a.low >= b, a.high >= b};
}
inline Mask8 operator<=(Double8 a, double b) {
  return {a.low <= b, a.high <= b};
}
inline Mask8 operator&(Mask8 a, Mask8 b) {
  return {a.low & b.low, a.high & b.high};
}

inline Double8 select(Mask8 mask, Double8 yes, Double8 no) {
  return {mask.low ? yes.low : no.low, mask.high ? yes.high : no.high};
}
inline double select(bool mask, double yes, double no) {
  return mask ? yes : no;
}

inline Double8 min(Double8 a, Double8 b) {
  return select(a < b, a, b);
}
inline double min(double a, double b) {
  return a < b ? a : b;
}
inline Double8 max(Double8 a, double b) {
  return select(a >= b, a, splat<Double8>(b));
}
inline double max(double a, double b) {
  return a >= b ? a : b;
}
inline Double8 clamp(Double8 a, double low, double high) {
  return min(max(a, low), splat<Double8>(high));
}
inline double clamp(double a, double low, double high) {
  return min(max(a, low), high);
}

// A number by which the farther of two neighbours is told: of any lane, as the lanes are close together.
inline double representative(double a) {
  return a;
}
inline double representative(Double8 a) {
  return a.low[0];
}

inline bool any(bool mask) {
  return mask;
}
inline bool any(Mask8 mask) {
  const Mask4 both = mask.low | mask.high;
  return ((both[0] | both[1]) | (both[2] | both[3])) != 0;
}

}  // namespace mayfly::fields
