// This library as a contender: see contender.h for how to talk to it.
#include "bench/native/operations.h"

int main(int argc, char** argv) {
  apollonius::bench::Operations operations;
  return contender::serve(
      argc, argv, [&](const contender::Request& request) { return operations.answer(request); });
}
