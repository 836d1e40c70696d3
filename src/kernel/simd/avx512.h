#pragma once

#include <immintrin.h>

#include <cstdint>
#include <type_traits>

/// Lanes of AVX-512 (F, VL, DQ, BW); `scalar.h` says what each operation means.
namespace candela::kernel::avx512 {

struct Index8 {
  __m256i v;

  static Index8 Unpack(uint32_t packed) {
    return {_mm256_srlv_epi32(_mm256_set1_epi32(static_cast<int>(packed)),
                              _mm256_setr_epi32(0, 3, 6, 9, 12, 15, 18, 21))};
  }
};

struct Float8 {
  static constexpr int kCount = 8;
  __m256 v;

  struct Mask {
    __mmask8 v;
    uint32_t Bits() const { return _cvtmask8_u32(v); }
    static Mask FromBits(uint32_t bits) { return {_cvtu32_mask8(bits)}; }
    friend Mask operator&(Mask a, Mask b) { return {_kand_mask8(a.v, b.v)}; }
  };

  static Float8 Load(const float* from) { return {_mm256_load_ps(from)}; }
  static Float8 Broadcast(float value) { return {_mm256_set1_ps(value)}; }
  void Store(float* to) const { _mm256_store_ps(to, v); }

  friend Float8 operator+(Float8 a, Float8 b) { return {_mm256_add_ps(a.v, b.v)}; }
  friend Float8 operator-(Float8 a, Float8 b) { return {_mm256_sub_ps(a.v, b.v)}; }
  friend Float8 operator*(Float8 a, Float8 b) { return {_mm256_mul_ps(a.v, b.v)}; }
  friend Float8 FusedSubtract(Float8 a, Float8 b, Float8 c) {
    return {_mm256_fmsub_ps(a.v, b.v, c.v)};
  }
  friend Float8 Min(Float8 a, Float8 b) { return {_mm256_min_ps(a.v, b.v)}; }
  friend Float8 Max(Float8 a, Float8 b) { return {_mm256_max_ps(a.v, b.v)}; }
  friend Mask operator<(Float8 a, Float8 b) { return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)}; }
  friend Mask operator<=(Float8 a, Float8 b) { return {_mm256_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)}; }
  friend Float8 Permute(Float8 from, Index8 index) {
    return {_mm256_permutevar8x32_ps(from.v, index.v)};
  }
};

struct Float16 {
  static constexpr int kCount = 16;
  __m512 v;

  struct Mask {
    __mmask16 v;
    uint32_t Bits() const { return _cvtmask16_u32(v); }
    friend Mask operator&(Mask a, Mask b) { return {_kand_mask16(a.v, b.v)}; }
  };

  static Float16 Load(const float* from) { return {_mm512_load_ps(from)}; }
  static Float16 Broadcast(float value) { return {_mm512_set1_ps(value)}; }
  void Store(float* to) const { _mm512_store_ps(to, v); }

  friend Float16 operator+(Float16 a, Float16 b) { return {_mm512_add_ps(a.v, b.v)}; }
  friend Float16 operator-(Float16 a, Float16 b) { return {_mm512_sub_ps(a.v, b.v)}; }
  friend Float16 operator*(Float16 a, Float16 b) { return {_mm512_mul_ps(a.v, b.v)}; }
  friend Float16 operator/(Float16 a, Float16 b) { return {_mm512_div_ps(a.v, b.v)}; }
  friend Float16 FusedSubtract(Float16 a, Float16 b, Float16 c) {
    return {_mm512_fmsub_ps(a.v, b.v, c.v)};
  }
  friend Float16 Min(Float16 a, Float16 b) { return {_mm512_min_ps(a.v, b.v)}; }
  friend Float16 Max(Float16 a, Float16 b) { return {_mm512_max_ps(a.v, b.v)}; }
  friend Mask operator<(Float16 a, Float16 b) { return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ)}; }
  friend Mask operator<=(Float16 a, Float16 b) {
    return {_mm512_cmp_ps_mask(a.v, b.v, _CMP_LE_OQ)};
  }
};

/// The lanes of `mask`, at most 8, side by side.
inline Float8 Compact(Float16 a, Float16::Mask mask) {
  return {_mm512_castps512_ps256(_mm512_maskz_compress_ps(mask.v, a.v))};
}

/// One step of Batcher's bitonic sort, "Sorting Networks and their Applications", 1968: lanes are
/// compared with their partners, and those of `kSmaller` keep the smaller one.
template <int kSmaller>
[[gnu::always_inline]] inline __m256i KeepOrdered(__m256i keys, __m256i partners) {
  return _mm256_blend_epi32(_mm256_max_epi32(keys, partners), _mm256_min_epi32(keys, partners),
                            kSmaller);
}

inline Index8 OrderFarToNear(Float8 distance, Float8::Mask mask) {
  // Distances are not negative, so their bits are ordered like signed numbers; -1 is below all.
  const __m256i lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
  const __m256i near = _mm256_andnot_si256(_mm256_set1_epi32(7), _mm256_castps_si256(distance.v));
  __m256i keys = _mm256_mask_or_epi32(_mm256_set1_epi32(-1), mask.v, near, lanes);
  keys = KeepOrdered<0b10101010>(keys, _mm256_shuffle_epi32(keys, 0b10110001));
  keys = KeepOrdered<0b11001100>(keys, _mm256_shuffle_epi32(keys, 0b00011011));
  keys = KeepOrdered<0b10101010>(keys, _mm256_shuffle_epi32(keys, 0b10110001));
  const __m256i backwards = _mm256_setr_epi32(7, 6, 5, 4, 3, 2, 1, 0);
  keys = KeepOrdered<0b11110000>(keys, _mm256_permutevar8x32_epi32(keys, backwards));
  keys = KeepOrdered<0b11001100>(keys, _mm256_shuffle_epi32(keys, 0b01001110));
  keys = KeepOrdered<0b10101010>(keys, _mm256_shuffle_epi32(keys, 0b10110001));
  return {keys};
}

inline void StorePairs(Float8 low, Float8 high, uint64_t* to) {
  const __m256 even = _mm256_unpacklo_ps(low.v, high.v), odd = _mm256_unpackhi_ps(low.v, high.v);
  _mm256_storeu_ps(reinterpret_cast<float*>(to), _mm256_permute2f128_ps(even, odd, 0x20));
  _mm256_storeu_ps(reinterpret_cast<float*>(to + 4), _mm256_permute2f128_ps(even, odd, 0x31));
}

/// Nodes of 8 children, for many rays in flight, and of 16.
template <int W>
struct IsaLanes {
  static constexpr int kWidth = W;
  static constexpr bool kMoves = false;
  using Node = std::conditional_t<W == 16, Float16, Float8>;
  using Leaf = Float8;
  using Index = Index8;
  using Packet = Float16;
};

}  // namespace candela::kernel::avx512
