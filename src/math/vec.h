#pragma once

#include <algorithm>
#include <cmath>

namespace candela {

/// A pair of numbers: texture coordinates, a position on the film, a random pair.
struct Vec2 {
  float x = 0, y = 0;

  friend constexpr bool operator==(Vec2, Vec2) = default;
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator*(Vec2 a, float s) { return {a.x * s, a.y * s}; }
  friend constexpr Vec2 operator*(float s, Vec2 a) { return a * s; }
};

/// Three components: a point, a direction or a normal; the name of the variable says which, and in
/// which space.
template <class T>
struct Vec3T {
  T x = 0, y = 0, z = 0;

  constexpr T operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }

  friend constexpr bool operator==(Vec3T, Vec3T) = default;
  friend constexpr Vec3T operator+(Vec3T a, Vec3T b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3T operator-(Vec3T a, Vec3T b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3T operator-(Vec3T a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3T operator*(Vec3T a, Vec3T b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend constexpr Vec3T operator*(Vec3T a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3T operator*(T s, Vec3T a) { return a * s; }
  friend constexpr Vec3T operator/(Vec3T a, T s) { return {a.x / s, a.y / s, a.z / s}; }
  constexpr Vec3T& operator+=(Vec3T b) { return *this = *this + b; }
  constexpr Vec3T& operator-=(Vec3T b) { return *this = *this - b; }
  constexpr Vec3T& operator*=(T s) { return *this = *this * s; }
};

using Vec3 = Vec3T<float>;
using Vec3d = Vec3T<double>;

template <class T>
constexpr T Dot(Vec3T<T> a, Vec3T<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
constexpr Vec3T<T> Cross(Vec3T<T> a, Vec3T<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
constexpr T LengthSquared(Vec3T<T> a) {
  return Dot(a, a);
}

template <class T>
T Length(Vec3T<T> a) {
  return std::sqrt(Dot(a, a));
}

/// A unit vector; not finite for the zero vector.
template <class T>
Vec3T<T> Normalize(Vec3T<T> a) {
  return a * (T{1} / Length(a));
}

template <class T>
constexpr Vec3T<T> Min(Vec3T<T> a, Vec3T<T> b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

template <class T>
constexpr Vec3T<T> Max(Vec3T<T> a, Vec3T<T> b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

template <class T>
Vec3T<T> Abs(Vec3T<T> a) {
  return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}

/// The largest of the magnitudes of the components.
template <class T>
T MaxAbs(Vec3T<T> a) {
  const Vec3T<T> m = Abs(a);
  return std::max(std::max(m.x, m.y), m.z);
}

/// The axis (0, 1 or 2) of the component of largest magnitude; the first one of equal ones.
template <class T>
int LargestAxis(Vec3T<T> a) {
  const Vec3T<T> m = Abs(a);
  return m.x >= m.y ? (m.x >= m.z ? 0 : 2) : (m.y >= m.z ? 1 : 2);
}

constexpr Vec3 ToFloat(Vec3d a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

constexpr Vec3d ToDouble(Vec3 a) {
  return {a.x, a.y, a.z};
}

/// A unit vector, for a vector of any length but 0: in double the squares of the smallest and of
/// the largest floats keep their value.
inline Vec3 NormalizeAnyLength(Vec3 a) {
  return ToFloat(Normalize(ToDouble(a)));
}

template <class T>
bool IsFinite(Vec3T<T> a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace candela
