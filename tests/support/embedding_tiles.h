#pragma once

#include <QtTest>

#include "core/base/parallel.h"
#include "core/base/predicates.h"
#include "core/fusion/embedding.h"
#include "tests/support/embedding_checks.h"
#include "tests/support/shapes.h"
#include "tests/support/tiles.h"

namespace graftsman {

using Method = EmbeddingSettings::Method;
using shapes::DiscTile;

inline Result<Embedding> embedTile(const DiscTile& tile, Method method = Method::Automatic,
                                   const Progress& progress = {}) {
  return embed(tile.points, tile.faces, tile.boundarySize, tile.corners, {method}, progress);
}

#define VERIFY_EMBEDS(tile, result)                                                 \
  QVERIFY2((result).has_value(), (result) ? "" : (result).error().message.c_str()); \
  QCOMPARE(brokenPromise(tile, *(result)), std::string())

}  // namespace graftsman
