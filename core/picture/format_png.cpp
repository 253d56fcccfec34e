#include <png.h>

#include "core/picture/picture.h"

namespace graftsman {

Result<std::string> formatPng(const Picture& picture) {
  static_assert(sizeof(Colour) == 3);
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.size.width);
  image.height = static_cast<png_uint_32>(picture.size.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  constexpr int kEightBits = 0;
  constexpr int kTightRows = 0;
  if (png_image_write_to_memory(&image, bytes.data(), &size, kEightBits, picture.pixels.data(), kTightRows,
                                nullptr) == 0) {
    return fail(ErrorCode::OutOfMemory, std::string("A picture could not be packed: ") +
                                            static_cast<const char*>(image.message) + ".");
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace graftsman
