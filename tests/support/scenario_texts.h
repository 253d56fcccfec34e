#pragma once

#include <QtTest>

#include "core/fusion/rigid_fit.h"
#include "core/io/printable.h"
#include "core/io/scenario.h"
#include "tests/support/samples.h"

namespace graftsman {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace graftsman
