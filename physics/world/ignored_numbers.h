#pragma once

#include <checks/hooks.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace fettle::physics::detail {

/// The values of a user function that are NaN and therefore change nothing. The log gets one
/// warning for all calls of the function in a step, which names the first value.
class IgnoredNumbers {
  public:
    /// True if `value` is a number. Otherwise it is counted; `where()` returns the function and the
    /// objects, as "the mixing callback, for shapes 4 and 5,".
    template <class Number, class Where>
    bool accepts(Number value, const char* name, Where&& where) {
        if (!std::isnan(value)) return true;
        if (++count_ == 1 && is_logged()) first_ = std::string(where()) + " set " + name;
        return false;
    }
    /// Writes the warning if there was a NaN, and resets the count.
    void report() {
        if (count_ == 0) return;
        log(LogLevel::warning,
            first_ + " to NaN, which changes nothing" +
                (count_ > 1 ? " (" + std::to_string(count_) + " values in this step)" : ""));
        *this = {};
    }

  private:
    uint32_t count_ = 0;
    std::string first_;
};

}  // namespace fettle::physics::detail
