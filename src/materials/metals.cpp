#include "materials/metals.h"

namespace candela {
namespace {

constexpr Metal kMetals[] = {
    // name      eta                                k
    {"gold", {0.143119f, 0.374957f, 1.442479f}, {3.983160f, 2.385721f, 1.603215f}},
    {"silver", {0.155265f, 0.116723f, 0.138381f}, {4.828343f, 3.122246f, 2.146950f}},
    {"copper", {0.200438f, 0.924033f, 1.102212f}, {3.912949f, 2.452848f, 2.142188f}},
    {"aluminium", {1.657460f, 0.880369f, 0.521229f}, {9.223869f, 6.269523f, 4.837001f}},
    {"brass", {0.444f, 0.527f, 1.094f}, {3.695f, 2.765f, 1.829f}},
    {"iron", {2.9114f, 2.9497f, 2.5845f}, {3.0893f, 2.9318f, 2.7670f}},
    {"chrome", {4.369683f, 2.916702f, 1.654701f}, {5.206434f, 4.231365f, 3.754947f}},
};

}  // namespace

std::span<const Metal> Metals() {
  return kMetals;
}

}  // namespace candela
