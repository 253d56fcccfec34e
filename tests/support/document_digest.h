#pragma once

#include <QByteArray>
#include <QCryptographicHash>
#include <algorithm>
#include <map>

#include "core/project/evaluate.h"

/// What documents come to, bit for bit, for tests.
namespace graftsman {

/// Of each fusion: of a result its bits, of none why.
using Digest = std::map<FusionId, QByteArray>;

inline QByteArray digestOf(const FusionResults& results) {
  QCryptographicHash hash(QCryptographicHash::Sha1);
  const auto add = [&hash](const auto& values) {
    hash.addData(QByteArray::fromRawData(reinterpret_cast<const char*>(values.data()),
                                         static_cast<qsizetype>(values.size() * sizeof(values[0]))));
  };
  if (results.error) {
    add(results.error->message);
  } else if (results.fused) {
    add(results.fused->points);
    add(results.fused->faces());
  }
  return hash.result();
}

inline Digest digestOf(const FusionList& fusions, Evaluated& known) {
  Digest digest;
  for (const auto& fusion : fusions) {
    digest[fusion->id] = digestOf(evaluate(fusions, fusion->id, known, {}).results);
  }
  return digest;
}

inline std::size_t resultsIn(const FusionList& fusions, Evaluated& known) {
  return static_cast<std::size_t>(std::ranges::count_if(fusions, [&](const auto& fusion) {
    return evaluate(fusions, fusion->id, known, {}).results.fused != nullptr;
  }));
}

}  // namespace graftsman
