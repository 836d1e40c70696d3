#pragma once

#include <vector>

#include "math/complex.h"
#include "math/spectrum.h"

namespace candela {

// Light that is reflected at both faces of a thin clear film interferes with itself. What comes
// back of all reflections inside is Airy's sum, for each polarisation: Born and Wolf, "Principles
// of Optics", chapter 7.6. Colours are its means over the responses of `ResponsesAt`, over which
// light of all wavelengths is spread: the subject of Belcour and Barla, "A Practical Extension to
// Microfacet Theory for the Modeling of Varying Iridescence", 2017, whose closed form we replace by
// tables of sums over wavelengths.

/// A film on a surface, as light from outside meets it: the refractive indices of the film and of
/// what is below it, over that of the outside, and that of the outside over air.
struct FilmStack {
  double film = 1;
  Complex base{1, 0};
  double outside = 1;
};

/// The reflectance of unpolarised light of one wavelength; that and the thickness of the film are
/// in nanometres. Without thickness it is that of the bare surface.
double FilmReflectance(const FilmStack& stack, double thickness, double wavelength, double cosine);

/// How much more than the bare surface one with a film reflects of red, green and blue: by the
/// cosine to the normal outside, and for thicknesses from `least` to `most`, in nanometres.
class FilmTable {
 public:
  /// `base_eta` + i `base_k` is the index of the base for each colour, over that of the outside;
  /// `film` and `outside` are as in `FilmStack`.
  FilmTable(double film, double outside, Rgb base_eta, Rgb base_k, float least, float most);

  /// The row of a thickness within the range.
  float RowOf(float thickness) const;
  Rgb At(float cosine, float row) const;
  /// What is reflected with the film where the bare surface reflects `bare`.
  Rgb Over(Rgb bare, float cosine, float row) const;
  /// The mean for light from everywhere.
  Rgb Mean(float row) const;

 private:
  struct Base {
    double film, outside;
    Rgb eta, k;
  };
  // For thicknesses that are `step` apart.
  void FillHorizon(const Base& base, double step);
  void FillColumn(int column, const Base& base, double step);
  static Rgb MeanOf(const Rgb* row);
  const Rgb* Row(int row) const;

  float least_, rows_per_nanometre_;
  int rows_;
  std::vector<Rgb> changes_;  ///< Row after row.
  std::vector<Rgb> means_;    ///< Of each row.
};

}  // namespace candela
