#pragma once
// Where what handlers throw goes while they are told of something.

#include <exception>
#include <utility>

namespace fettle::property {

/// While it lives, `failure` leads to `first`: the first error is thrown when all are told.
class FailureScope {
  public:
    FailureScope(std::exception_ptr*& failure, std::exception_ptr& first)
        : failure_(failure), before_(std::exchange(failure, &first)) {}
    ~FailureScope() { failure_ = before_; }
    FailureScope(const FailureScope&) = delete;

  private:
    std::exception_ptr*& failure_;
    std::exception_ptr* before_;
};

}  // namespace fettle::property
