#include "core/project/document.h"

#include <algorithm>
#include <set>

namespace graftsman {
namespace {

// Whether both lists hold equal values; the very same ones are not looked into.
template <class List>
bool equal(const List& a, const List& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x == y || *x == *y; });
}

template <class List, class Id>
auto* withId(const List& list, Id id) {
  const auto found = std::find_if(list.begin(), list.end(), [id](const auto& one) { return one->id == id; });
  return found == list.end() ? nullptr : found->get();
}

void collect(const FusionList& fusions, FusionId id, std::set<FusionId>& met, std::vector<FusionId>& order) {
  const Fusion* fusion = find(fusions, id);
  if (fusion == nullptr || !met.insert(id).second) {
    return;
  }
  for (const Side side : {Side::Part, Side::Base}) {
    if (const FusionId upstream = fusion->upstream(side)) {
      collect(fusions, upstream, met, order);
    }
  }
  order.push_back(id);
}

}  // namespace

bool operator==(const Variant& a, const Variant& b) {
  return a.id == b.id && a.name == b.name && a.note == b.note && a.starred == b.starred &&
         a.shown == b.shown && equal(a.fusions, b.fusions);
}

bool operator==(const Document& a, const Document& b) {
  return equal(a.fusions, b.fusions) && equal(a.variants, b.variants);
}

const Fusion* find(const FusionList& fusions, FusionId id) {
  return withId(fusions, id);
}

const Variant* find(const VariantList& variants, VariantId id) {
  return withId(variants, id);
}

std::vector<FusionId> upstreamOf(const FusionList& fusions, FusionId id) {
  std::set<FusionId> met;
  std::vector<FusionId> order;
  collect(fusions, id, met, order);
  return order;
}

}  // namespace graftsman
