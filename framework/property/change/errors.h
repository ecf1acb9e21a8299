#pragma once
// Where what handlers throw goes.

#include <exception>
#include <functional>
#include <string>
#include <utility>

#include <fettle/property/change.h>

#include <guards/lifetime.h>

namespace fettle::property {

struct HandlerErrors {
    const Lifetime& lifetime;
    std::function<void(const HandlerError&)> sink{};
    std::exception_ptr* first = nullptr;  // where the first goes without a sink: `Collect`

    /// To the sink.
    void tell(const HandlerError& error) const;
    /// In a handler of exceptions: the one at hand goes to the sink. Without a sink, and where that
    /// throws, it is kept in `kept` unless there is one: the others are told all the same.
    void report(std::exception_ptr& kept, const std::function<std::string()>& path,
                const std::string& where = {}) const;

    /// While it lives, handlers are called; the first error is thrown when all are told.
    class Collect {
      public:
        Collect(HandlerErrors& errors, std::exception_ptr& first)
            : first_(errors.first), before_(std::exchange(errors.first, &first)) {}
        ~Collect() { first_ = before_; }
        Collect(const Collect&) = delete;

      private:
        std::exception_ptr*& first_;
        std::exception_ptr* before_;
    };
};

}  // namespace fettle::property
