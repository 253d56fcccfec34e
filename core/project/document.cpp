#include "core/project/document.h"

namespace graftsman {

bool same(const FusionInputs& a, const FusionInputs& b) {
  return a.part == b.part && a.base == b.base && a.loop == b.loop && a.paths == b.paths &&
         a.tile.allowLargeTile == b.tile.allowLargeTile && a.adjustment == b.adjustment &&
         a.embedding == b.embedding && a.fcf == b.fcf;
}

bool operator==(const Document& a, const Document& b) {
  return a.part == b.part && a.base == b.base && a.closed == b.closed && same(a.inputs, b.inputs);
}

}  // namespace graftsman
