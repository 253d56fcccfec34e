#pragma once

#include <cstddef>
#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// A heap of (key, value) with the smallest key on top; four children a node, for fewer cache misses than
/// two. A value whose key falls is pushed again; whoever pops it sees that the older entry is stale.
class MinHeap {
 public:
  struct Entry {
    double key;
    Index value;
  };

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] const Entry& top() const { return entries_.front(); }

  void push(double key, Index value) {
    std::size_t i = entries_.size();
    entries_.push_back({key, value});
    while (i > 0) {
      const std::size_t parent = (i - 1) / 4;
      if (entries_[parent].key <= key) {
        break;
      }
      entries_[i] = entries_[parent];
      i = parent;
    }
    entries_[i] = {key, value};
  }

  Entry pop() {
    const Entry result = entries_.front();
    const Entry last = entries_.back();
    entries_.pop_back();
    if (!entries_.empty()) {
      sift(last);
    }
    return result;
  }

 private:
  void sift(const Entry& entry) {
    const std::size_t size = entries_.size();
    std::size_t i = 0;
    for (std::size_t child = 1; child < size; child = 4 * i + 1) {
      std::size_t least = child;
      const std::size_t end = child + 4 < size ? child + 4 : size;
      for (std::size_t c = child + 1; c < end; ++c) {
        if (entries_[c].key < entries_[least].key) {
          least = c;
        }
      }
      if (entry.key <= entries_[least].key) {
        break;
      }
      entries_[i] = entries_[least];
      i = least;
    }
    entries_[i] = entry;
  }

  std::vector<Entry> entries_;
};

}  // namespace graftsman
