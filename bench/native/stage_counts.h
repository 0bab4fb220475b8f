// How often each stage of the predicates answered, as JSON.
#pragma once

#include <cstddef>
#include <string>

namespace apollonius::bench::stages {

void reset();
/// `,"stages":{"vertexFilter":12.3,...}`: answers per item since the last reset, without the zeros.
std::string perItem(std::size_t items);

}  // namespace apollonius::bench::stages
