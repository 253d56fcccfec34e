#pragma once

#include <QString>
#include <vector>

namespace graftsman {

/// A sample fusion of the start page.
struct Sample {
  QString path;     // of the scenario
  QString title;    // "A cone for a nose"
  QString picture;  // of its result, PNG
};

/// The samples that are installed (or lie in the source tree the program was built in), best first.
[[nodiscard]] std::vector<Sample> findSamples();

}  // namespace graftsman
