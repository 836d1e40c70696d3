#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "film/encode_film.h"
#include "render/tiles.h"

namespace candela {

/// Passes finished rows of tiles to an encoder, in order, on the thread that finished them, while
/// the other threads go on with later tiles.
class RowFeed {
 public:
  /// `encoder` may be null; both have to outlive the feed.
  RowFeed(const Tiles& tiles, FilmEncoder* encoder)
      : tiles_(tiles), encoder_(encoder), done_(static_cast<size_t>(tiles.Rows())) {}

  /// Called by any thread once a tile is in the film.
  void TileDone(int64_t tile) {
    if (!encoder_) return;
    std::unique_lock lock(mutex_);
    ++done_[static_cast<size_t>(tile / tiles_.Columns())];
    if (is_feeding_) return;  // The thread that feeds looks again after each row of tiles.
    is_feeding_ = true;
    while (next_ < done_.size() && done_[next_] == tiles_.Columns()) {
      lock.unlock();
      encoder_->Advance(tiles_.RowEnd(static_cast<int64_t>(next_)));
      lock.lock();
      ++next_;
    }
    is_feeding_ = false;
  }

 private:
  const Tiles& tiles_;
  FilmEncoder* encoder_;
  std::mutex mutex_;
  std::vector<int64_t> done_;  ///< Finished tiles in each row of tiles.
  size_t next_ = 0;            ///< The first row of tiles that is not fed yet.
  bool is_feeding_ = false;
};

}  // namespace candela
