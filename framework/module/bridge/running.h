#pragma once
// Notes which function of a module runs now.

#include <atomic>

#include <fettle/module/running.h>

namespace fettle::module {

/// What a function belongs to. It must not move while the function runs.
struct Named {
    const char* module = nullptr;
    const char* class_name = nullptr;
    const char* member = nullptr;
};

inline std::atomic<const Named*> running_owner{nullptr};
inline std::atomic<const char*> running_name{nullptr};

/// While it lives, a function of a module runs. `function` is a literal.
class Running {
  public:
    Running(const Named& owner, const char* function)
        : owner_(running_owner.load(std::memory_order_relaxed)),
          function_(running_name.load(std::memory_order_relaxed)) {
        note(&owner, function);
    }
    ~Running() { note(owner_, function_); }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

  private:
    static void note(const Named* owner, const char* function) {
        running_owner.store(owner, std::memory_order_relaxed);
        running_name.store(function, std::memory_order_relaxed);
    }

    const Named* const owner_;
    const char* const function_;
};

}  // namespace fettle::module
