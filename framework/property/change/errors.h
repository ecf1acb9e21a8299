#pragma once
// Where the exceptions of handlers go.

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
    std::exception_ptr* first = nullptr;  // used without a sink; see `Collect`

    /// Calls the sink.
    void report(const HandlerError& error) const;
    /// Called in a `catch` block: passes the current exception to the sink. Without a sink, or if
    /// the sink throws, the exception is stored in `kept` unless `kept` holds one already. So the
    /// remaining handlers are called all the same.
    void report(std::exception_ptr& kept, const std::function<std::string()>& path,
                const std::string& where = {}) const;

    /// While it lives, the first exception of a handler is collected. The owner throws it after all
    /// handlers were called.
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
