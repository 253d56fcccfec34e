#pragma once

#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace graftsman {

/// An array of fixed size that starts as zero bytes and costs memory and time only where it is touched: large
/// ones come from the system as untouched pages. So a local search may have one entry for each vertex of a
/// large mesh.
template <class T>
class ZeroedArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  ZeroedArray() = default;
  explicit ZeroedArray(std::size_t size) : data_(static_cast<T*>(std::calloc(size + 1, sizeof(T)))) {
    if (!data_) {
      throw std::bad_alloc();
    }
  }

  template <class Integer>
  [[nodiscard]] T& operator[](Integer i) {
    return data_.get()[static_cast<std::size_t>(i)];
  }
  template <class Integer>
  [[nodiscard]] const T& operator[](Integer i) const {
    return data_.get()[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] bool allocated() const { return data_ != nullptr; }

 private:
  struct Free {
    void operator()(T* data) const { std::free(data); }
  };
  std::unique_ptr<T, Free> data_;
};

}  // namespace graftsman
