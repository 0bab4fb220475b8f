// A reference to a function, as an argument for the time of a call: the function is neither copied
// nor owned, and the callee need not be a template. (std::function_ref of C++26.)
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace apollonius::internal {

template <class Signature>
class FunctionRef;

template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
 public:
  template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef>)
  // NOLINTNEXTLINE(google-explicit-constructor): as lambdas are given
  FunctionRef(const Function& function)
      : object_(std::addressof(function)), call_([](const void* object, Arguments... arguments) {
          return (*static_cast<const Function*>(object))(std::forward<Arguments>(arguments)...);
        }) {}
  Result operator()(Arguments... arguments) const {
    return call_(object_, std::forward<Arguments>(arguments)...);
  }

 private:
  const void* object_;
  Result (*call_)(const void*, Arguments...);
};

}  // namespace apollonius::internal
