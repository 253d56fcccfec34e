#pragma once

#include <zip.h>

namespace graftsman {

/// libzip's account of why something could not be opened or made.
struct ZipError {
  zip_error_t value;

  ZipError() { zip_error_init(&value); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;
  ~ZipError() { zip_error_fini(&value); }
};

}  // namespace graftsman
