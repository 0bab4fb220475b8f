#include "predicate/bounded_center.h"

namespace apollonius::internal {

template Existence findCenter(const Row<Twofold>& j, const Row<Twofold>& k, const Row<Twofold>& jk,
                              BoundedCenter<Twofold>& center);

}  // namespace apollonius::internal
