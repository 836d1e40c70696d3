#include "tests/malformed/companions.h"

#include <sys/stat.h>

#include <map>
#include <string>
#include <utility>

#include "tests/image/png_builder.h"
#include "tests/support/temp_folder.h"

namespace candela {
namespace fs = std::filesystem;
namespace {

using testing_support::Put;

/// Two by two grey pixels.
const std::string kScanlines = Bytes({0, 10, 20, 0, 30, 40});

std::string Header() {
  return PngHeader(2, 2, 8, 0);
}
std::string Data() {
  return PngChunk("IDAT", Deflate(kScanlines));
}
std::string End() {
  return PngChunk("IEND", "");
}
std::string Sound() {
  return PngFile({Header(), Data(), End()});
}

/// The same with another last byte: of a chunk that is its checksum.
std::string Damaged(std::string chunk) {
  chunk.back() = static_cast<char>(chunk.back() ^ 1);
  return chunk;
}

/// A whole set of faces; those in `others` by name, the rest sound.
void PutFaces(const fs::path& folder, const std::map<std::string, std::string>& others) {
  fs::create_directory(folder);
  for (const std::string name : {"left", "right", "up", "down", "front", "back"}) {
    const auto other = others.find(name);
    Put(folder / (name + ".png"), other == others.end() ? Sound() : other->second);
  }
}

void PutUnusualLegalFaces(const fs::path& folder) {
  const std::string palette = PngFile({PngHeader(1, 1, 1, 3), PngChunk("PLTE", "rgbRGB"),
                                       PngChunk("IDAT", Deflate(Bytes({0, 0x80}))), End()});
  PutFaces(folder, {{"left", PngOf(PngHeader(1, 1, 8, 0), Bytes({0, 9}))},
                    {"right", PngOf(PngHeader(1, 1, 8, 4), Bytes({0, 9, 128}))},
                    {"up", PngOf(PngHeader(1, 2, 16, 0), Bytes({0, 9, 9, 0, 8, 8}))},
                    {"down", palette},
                    {"front", PngOf(PngHeader(1, 1, 8, 6), Bytes({0, 1, 2, 3, 4}))}});
}

}  // namespace

void MakeCompanions(const fs::path& set) {
  const fs::path files = set / "files";
  fs::create_directory(files / "folder");
  ::mkfifo((files / "pipe").c_str(), 0600);
  fs::create_symlink("/dev/null", files / "device");
  fs::create_symlink("nothing", files / "link_to_nothing");

  const fs::path maps = set / "cube_maps";
  const std::string stream = Deflate(kScanlines);
  const std::string palette_data = PngChunk("IDAT", Deflate(Bytes({0, 0, 1, 0, 2, 0})));
  const std::pair<std::string, std::string> front_faces[] = {
      {"face_is_empty", ""},
      {"face_is_a_text", "this is no picture"},
      {"header_checksum", PngFile({Damaged(Header()), Data(), End()})},
      {"data_checksum", PngFile({Header(), Damaged(Data()), End()})},
      {"pixels_checksum", PngFile({Header(), PngChunk("IDAT", Damaged(stream)), End()})},
      {"too_little_data", PngOf(Header(), kScanlines.substr(0, 5))},
      {"bad_filter", PngOf(Header(), Bytes({0, 10, 20, 5, 30, 40}))},
      {"bad_depth", PngOf(PngHeader(2, 2, 3, 0), kScanlines)},
      {"bad_colour_type", PngOf(PngHeader(2, 2, 8, 1), kScanlines)},
      {"bad_chunk_length", PngFile({Header(), "\x7f" + Data(), End()})},
      {"palette_missing", PngFile({PngHeader(2, 2, 8, 3), palette_data, End()})},
      {"palette_too_short",
       PngFile({PngHeader(2, 2, 8, 3), PngChunk("PLTE", "rgbRGB"), palette_data, End()})},
      {"header_promises_too_much", PngFile({PngHeader(40000, 40000, 16, 6), Data(), End()})},
      {"size_zero", PngOf(PngHeader(0, 2, 8, 0), "")},
      {"surplus_data", PngOf(Header(), kScanlines + "more")},
      {"end_missing", PngFile({Header(), Data()})},
      {"ancillary_checksum", PngFile({Header(), Damaged(PngChunk("tEXt", "a")), Data(), End()})},
  };
  for (const auto& [defect, face] : front_faces) {
    PutFaces(maps / (defect + "_faces"), {{"front", face}});
  }
  PutFaces(maps / "two_faces_wrong_faces", {{"left", "no picture"}, {"back", "none either"}});
  PutUnusualLegalFaces(maps / "grey_alpha_palette_16_bit_and_unequal_faces");
  PutFaces(maps / "face_missing_faces", {});
  fs::remove(maps / "face_missing_faces" / "front.png");
  PutFaces(maps / "face_is_a_folder_faces", {});
  fs::remove(maps / "face_is_a_folder_faces" / "front.png");
  fs::create_directory(maps / "face_is_a_folder_faces" / "front.png");
}

}  // namespace candela
