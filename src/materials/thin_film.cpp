#include "materials/thin_film.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "materials/table_place.h"
#include "math/elementary.h"
#include "math/wavelength.h"

namespace candela {
namespace {

constexpr int kColumns = 129;
// From one row to the next the phase of light changes by less than a sixth of a radian.
constexpr double kRowsPerOpticalNanometre = 0.2;
// The responses have their corners at multiples of this, so sums by trapezoids weigh them rightly.
constexpr double kWavelengthStep = 2.5;

/// What the two faces of a film send back of the amplitude, for either polarisation.
struct Faces {
  Complex outer_s, outer_p, inner_s, inner_p;
};

/// Keeps a square off 0, where a wave runs along the film and the quotients have no value. What is
/// reflected there is the limit, which this is as near to as numbers tell.
Complex OffZero(Complex square) {
  constexpr double kLeast = 1e-12;
  return Norm(square) < kLeast * kLeast ? Complex{kLeast, 0} : square;
}

/// Fresnel's amplitudes from `a` to `b`, given the squares of the indices and the parts of the wave
/// vectors along the normal.
Complex AmplitudeS(Complex a_normal, Complex b_normal) {
  return (a_normal - b_normal) / (a_normal + b_normal);
}
Complex AmplitudeP(Complex a_square, Complex a_normal, Complex b_square, Complex b_normal) {
  const Complex a = b_square * a_normal, b = a_square * b_normal;
  return (a - b) / (a + b);
}

/// A film as it meets light at one angle. Wave vectors are in units of that outside.
struct Incidence {
  Incidence(double film, double cosine_outside)
      : cosine(cosine_outside),
        sine2(1 - cosine * cosine),
        film2{film * film, 0},
        normal(Sqrt(OffZero({film * film - sine2, 0}))) {}

  Faces On(Complex base) const {
    const Complex base2 = OffZero(base * base);
    const Complex base_normal = Sqrt(OffZero(base2 - Complex{sine2, 0}));
    return {AmplitudeS({cosine, 0}, normal), AmplitudeP({1, 0}, {cosine, 0}, film2, normal),
            AmplitudeS(normal, base_normal), AmplitudeP(film2, normal, base2, base_normal)};
  }

  /// What becomes of a wave on its way to the base and back, by the thickness over the wavelength
  /// outside: it turns, or fades when it runs along the film.
  Complex ThereAndBack(double thickness) const {
    const double turns = 4 * kPi * thickness;
    const double angle = turns * normal.re;
    return Complex{Cos(angle), Sin(angle)} * Exp(-turns * normal.im);
  }

  double cosine, sine2;
  Complex film2, normal;
};

/// Airy's sum r + t t' q (1 + r' q + ...) with q that of the inner face and the way to it, in which
/// t t' = 1 - r^2 and r' = -r; its share of the power.
double AirySum(Complex outer, Complex inner, Complex way) {
  const Complex q = inner * way;
  return Norm(outer + q) / Norm(Complex{1, 0} + outer * q);
}
/// Rounding may leave it above 1.
double Reflectance(const Faces& faces, Complex way) {
  return (AirySum(faces.outer_s, faces.inner_s, way) + AirySum(faces.outer_p, faces.inner_p, way)) /
         2;
}

/// The same where no wave fades in the film, which means that the outer face sends back a real part
/// of the amplitude and that the way only turns: with r of the outer face, s of the inner one and
/// x = 2 r Re(s way) it is (r^2 + |s|^2 + x) / (1 + r^2 |s|^2 + x).
class Fringes {
 public:
  explicit Fringes(const Faces& faces)
      : s_(faces.outer_s.re, faces.inner_s), p_(faces.outer_p.re, faces.inner_p) {}

  double Reflectance(Complex way) const {
    const double s = s_.Swing(way), p = p_.Swing(way);
    const double below_s = s_.below + s, below_p = p_.below + p;
    return ((s_.above + s) * below_p + (p_.above + p) * below_s) / (2 * below_s * below_p);
  }

 private:
  struct Polarisation {
    Polarisation(double outer, Complex inner)
        : swing(inner * (2 * outer)),
          above(outer * outer + Norm(inner)),
          below(1 + outer * outer * Norm(inner)) {}
    double Swing(Complex way) const { return swing.re * way.re - swing.im * way.im; }
    Complex swing;
    double above, below;
  };
  Polarisation s_, p_;
};

/// The wavelengths of a sum and what they count for each colour, which adds up to 1.
struct Wavelengths {
  /// So close to each other that light of neighbours comes back in nearly the same phase from a
  /// film of that optical thickness.
  explicit Wavelengths(double optical_thickness) {
    const double parts = std::clamp(std::ceil(optical_thickness / 700), 1.0, 4.0);
    const double step = kWavelengthStep / parts;
    const auto range = double{kLongestWavelength} - double{kShortestWavelength};
    const auto count = static_cast<int>(range / step + 0.5) + 1;
    for (int i = 0; i < count; ++i) {
      at.push_back(double{kShortestWavelength} + step * i);
      weights.push_back(ResponsesAt(static_cast<float>(at.back())) * static_cast<float>(step));
    }
  }
  std::vector<double> at;
  std::vector<Rgb> weights;
};

/// Close to each other at the horizon, where the reflectance of metals has a steep end.
float CosineOf(int column) {
  const float root = static_cast<float>(column) / (kColumns - 1);
  return root * root;
}

}  // namespace

double FilmReflectance(const FilmStack& stack, double thickness, double wavelength, double cosine) {
  if (!(cosine > 0)) return 1;
  const Incidence incidence(stack.film, cosine);
  const Complex way = incidence.ThereAndBack(thickness * stack.outside / wavelength);
  return std::min(Reflectance(incidence.On(stack.base), way), 1.0);
}

FilmTable::FilmTable(double film, double outside, Rgb base_eta, Rgb base_k, float least, float most)
    : least_(least), rows_per_nanometre_(0), rows_(1) {
  const double range = double{most} - double{least};
  if (range > 0) {
    rows_ = 2 + static_cast<int>(range * film * outside * kRowsPerOpticalNanometre);
    rows_per_nanometre_ = static_cast<float>((rows_ - 1) / range);
  }
  const Base base{film, outside, base_eta, base_k};
  const double step = rows_ > 1 ? range / (rows_ - 1) : 0;
  changes_.resize(static_cast<size_t>(rows_) * kColumns);
  FillHorizon(base, step);
  ParallelFor(kColumns - 1, [&](int64_t i) { FillColumn(static_cast<int>(i) + 1, base, step); });
  for (int row = 0; row < rows_; ++row) means_.push_back(MeanOf(Row(row)));
}

// In the first column everything is reflected, also by the bare surface, but where the base is as
// the outside: there by the film alone.
void FilmTable::FillHorizon(const Base& base, double step) {
  for (int c = 0; c < 3; ++c) {
    const bool is_film_alone = base.eta[c] == 1 && base.k[c] == 0 && base.film != 1;
    if (!is_film_alone) continue;
    for (int row = 0; row < rows_; ++row) {
      const bool is_there = double{least_} + step * row > 0;
      changes_[static_cast<size_t>(row) * kColumns][c] = is_there ? 1 : 0;
    }
  }
}

void FilmTable::FillColumn(int column, const Base& base, double step) {
  const Incidence incidence(base.film, double{CosineOf(column)});
  Faces faces[3];
  for (int c = 0; c < 3; ++c) {
    faces[c] = incidence.On({double{base.eta[c]}, double{base.k[c]}});
  }
  const bool is_grey = base.eta == Rgb{base.eta.x, base.eta.x, base.eta.x} &&
                       base.k == Rgb{base.k.x, base.k.x, base.k.x};
  const bool is_waving = incidence.normal.im == 0;
  const Fringes fringes[] = {Fringes(faces[0]), Fringes(faces[1]), Fringes(faces[2])};
  const auto reflectance = [&](int c, Complex way) {
    return is_waving ? fringes[c].Reflectance(way) : Reflectance(faces[c], way);
  };
  const double bare[] = {reflectance(0, {1, 0}), reflectance(1, {1, 0}), reflectance(2, {1, 0})};
  const double thickest = double{least_} + step * (rows_ - 1);
  const Wavelengths wavelengths(thickest * base.film * base.outside);
  const size_t count = wavelengths.at.size();
  std::vector<Complex> ways, further;
  for (const double wavelength : wavelengths.at) {
    ways.push_back(incidence.ThereAndBack(double{least_} * base.outside / wavelength));
    further.push_back(incidence.ThereAndBack(step * base.outside / wavelength));
  }
  for (int row = 0; row < rows_; ++row) {
    double sums[3] = {};
    for (size_t i = 0; i < count; ++i) {
      double change = 0;
      for (int c = 0; c < 3; ++c) {
        const auto weight = double{wavelengths.weights[i][c]};
        if (!(weight > 0)) continue;
        if (!is_grey || change == 0) change = reflectance(c, ways[i]) - bare[c];
        sums[c] += weight * change;
      }
      ways[i] = ways[i] * further[i];
    }
    Rgb& change = changes_[static_cast<size_t>(row) * kColumns + static_cast<size_t>(column)];
    for (int c = 0; c < 3; ++c) change[c] = static_cast<float>(sums[c]);
  }
}

// Weighted by the cosine, over straight lines between the columns.
Rgb FilmTable::MeanOf(const Rgb* row) {
  Rgb mean{};
  for (int column = 0; column + 1 < kColumns; ++column) {
    const float a = CosineOf(column), b = CosineOf(column + 1);
    mean += row[column] * ((b - a) * (2 * a + b) / 3);
    mean += row[column + 1] * ((b - a) * (a + 2 * b) / 3);
  }
  return mean;
}

const Rgb* FilmTable::Row(int row) const {
  return &changes_[static_cast<size_t>(row) * kColumns];
}

float FilmTable::RowOf(float thickness) const {
  return (thickness - least_) * rows_per_nanometre_;
}

Rgb FilmTable::At(float cosine, float row) const {
  // Rounding may leave a cosine of nearly 0 below it.
  const float place_of_column = std::sqrt(std::max(cosine, 0.0f)) * (kColumns - 1);
  const int column = std::min(static_cast<int>(place_of_column), kColumns - 2);
  const float a = CosineOf(column), b = CosineOf(column + 1);
  const float part = std::clamp((cosine - a) / (b - a), 0.0f, 1.0f);
  const auto in_row = [&](int index) {
    const Rgb* here = Row(index) + column;
    return here[0] * (1 - part) + here[1] * part;
  };
  const TablePlace place(row, rows_);
  if (place.part == 0) return in_row(place.index);
  return in_row(place.index) * (1 - place.part) + in_row(place.index + 1) * place.part;
}

Rgb FilmTable::Over(Rgb bare, float cosine, float row) const {
  return Max(Rgb{0, 0, 0}, Min(bare + At(cosine, row), Rgb{1, 1, 1}));
}

Rgb FilmTable::Mean(float row) const {
  const TablePlace place(row, rows_);
  const Rgb* here = &means_[static_cast<size_t>(place.index)];
  return place.part == 0 ? here[0] : here[0] * (1 - place.part) + here[1] * place.part;
}

}  // namespace candela
