#pragma once

#include <cstdint>

#include "math/vec.h"

/// Four floats at once, with the vector extensions that GCC and clang share; every machine has
/// registers for them. Three lanes are x, y and z, the fourth is free for the caller.
namespace candela {

typedef float Float4 __attribute__((vector_size(16)));
typedef int32_t Int4 __attribute__((vector_size(16)));
/// Not for parameters or results: only AVX has registers for it.
typedef double Double4 __attribute__((vector_size(32)));

inline Float4 Broadcast(float value) {
  return Float4{value, value, value, value};
}
inline Float4 ToFloat4(Vec3 v) {
  return Float4{v.x, v.y, v.z, 0};
}
inline Vec3 ToVec3(Float4 v) {
  return {v[0], v[1], v[2]};
}
inline Float4 Min(Float4 a, Float4 b) {
  return a < b ? a : b;
}
inline Float4 Max(Float4 a, Float4 b) {
  return a > b ? a : b;
}
inline Float4 Abs(Float4 a) {
  constexpr int32_t kAllButSign = 0x7fffffff;
  return reinterpret_cast<Float4>(reinterpret_cast<Int4>(a) &
                                  Int4{kAllButSign, kAllButSign, kAllButSign, kAllButSign});
}
/// Zero in the fourth lane, which may hold anything, also what is slow to calculate with.
inline Float4 Xyz(Float4 a) {
  return reinterpret_cast<Float4>(reinterpret_cast<Int4>(a) & Int4{-1, -1, -1, 0});
}
inline uint32_t FourthBits(Float4 a) {
  return static_cast<uint32_t>(reinterpret_cast<Int4>(a)[3]);
}
inline Float4 WithFourthBits(Float4 a, uint32_t bits) {
  Int4 result = reinterpret_cast<Int4>(a);
  result[3] = static_cast<int32_t>(bits);
  return reinterpret_cast<Float4>(result);
}
inline float LargestOf3(Float4 a) {
  const float xy = a[0] > a[1] ? a[0] : a[1];
  return xy > a[2] ? xy : a[2];
}

}  // namespace candela
